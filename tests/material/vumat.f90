! A VUMAT in Fortran: von Mises plasticity with linear hardening, and the pressure K (rho/rho0 - 1).
!   props  rho0, K, G, Y, H       state  equivalent plastic strain
subroutine copper_in_fortran(nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal, stepTime, totalTime, dt, cmname, &
                             coordMp, charLength, props, density, strainInc, relSpinInc, tempOld, stretchOld, &
                             defgradOld, fieldOld, stressOld, stateOld, enerInternOld, enerInelasOld, tempNew, &
                             stretchNew, defgradNew, fieldNew, stressNew, stateNew, enerInternNew, enerInelasNew)
  implicit none
  integer, parameter :: real = kind(1d0)
  integer, intent(in) :: nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal
  real(real), intent(in) :: stepTime, totalTime, dt
  character(80), intent(in) :: cmname
  real(real), intent(in), dimension(nblock) :: charLength, density, tempOld, tempNew, enerInternOld, enerInelasOld
  real(real), intent(in), dimension(nblock, ndir + nshr) :: strainInc, stretchOld, stretchNew, stressOld
  real(real), intent(in), dimension(nblock, ndir + 2*nshr) :: defgradOld, defgradNew
  real(real), intent(in) :: coordMp(nblock, 3), props(nprops), relSpinInc(nblock, nshr), fieldOld(nblock, nfieldv), &
                            fieldNew(nblock, nfieldv), stateOld(nblock, nstatev)
  real(real), intent(out) :: stressNew(nblock, ndir + nshr), stateNew(nblock, nstatev), enerInternNew(nblock), &
                             enerInelasNew(nblock)
  real(real) :: rho0, K, G, Y, H, theta, q, plastic, p, s(6), e(6)
  integer :: i

  rho0 = props(1); K = props(2); G = props(3); Y = props(4); H = props(5)
  do i = 1, nblock
    e = strainInc(i, :)
    theta = sum(e(1:3))
    s = stressOld(i, :) + 2*G*e
    s(1:3) = s(1:3) - sum(s(1:3))/3
    q = sqrt(1.5d0*(sum(s(1:3)**2) + 2*sum(s(4:6)**2)))
    plastic = max(0d0, q - Y - H*stateOld(i, 1))/(3*G + H)
    if (plastic > 0) s = (1 - 3*G*plastic/q)*s
    p = K*(density(i)/(rho0*(1 + 0.5d0*theta)) - 1)  ! the density given is that in the middle of the step
    stressNew(i, :) = s
    stressNew(i, 1:3) = s(1:3) - p
    stateNew(i, 1) = stateOld(i, 1) + plastic
    enerInternNew(i) = enerInternOld(i) + 0.5d0*dot_product(stressOld(i, :) + stressNew(i, :), [1, 1, 1, 2, 2, 2]*e)/density(i)
    enerInelasNew(i) = enerInelasOld(i) + (q - 3*G*plastic)*plastic/density(i)
  end do
end subroutine
