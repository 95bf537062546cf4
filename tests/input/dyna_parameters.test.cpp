#include <filesystem>
#include <fstream>
#include <string>

#include <strike/input/dyna.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

DynaDeck read(const std::string& text) { return read_dyna(text, "a.k"); }
double end_time(const std::string& parameters, const std::string& field) {
  return read(parameters + "*CONTROL_TERMINATION\n" + field + "\n").end_time;
}

}  // namespace

TEST_CASE("dyna parameters: values stand wherever a number may stand") {
  const DynaDeck deck = read(R"(*KEYWORD
*PARAMETER
$#  prmr1      val1     prmr2      val2     prmr3      val3     prmr4      val4
R     size       2.0I   number         7R     half   &size/4C     Kind     SHELL
rgap,0.25, I last , 4
*PARAMETER_EXPRESSION
R end     &half +
          2*&gap
I count   (number-&last)/2
rlater,end/(number-1)
*NODE
       1          &size             0.0           &SIZE
       2         &size             0.0
       3          -&size           &half
&last,,&half
*ELEMENT_&kind
  &count  &count       1       2       3   &last
*PART
plate
 &count,<min(3,number)>,<last-2>
*SET_NODE
    &last
 &last, <number-4>
*CONTROL_TERMINATION
    &end/2
*CONTROL_TIMESTEP
,&later*3
)");
  CHECK(deck.mesh.nodes[0] == Eigen::Vector3d(2, 0, 2));
  CHECK(deck.mesh.nodes[2] == Eigen::Vector3d(-2, 0.5, 0));
  CHECK(deck.mesh.nodes[3] == Eigen::Vector3d(0, 0.5, 0));
  CHECK(deck.mesh.quadrilaterals == Cells<4>{{0, 1, 2, 3}});
  CHECK(deck.cell_numbers == std::vector<FileNumber>{1});
  CHECK(deck.parts[0].number == 1);
  CHECK(deck.part_cards[0].section == 3);
  CHECK(deck.part_cards[0].material == 2);
  CHECK(deck.nodes(4) == std::vector<Index>{2, 3});
  CHECK(deck.end_time == 0.5);                 // (0.5 + 2*0.25)/2
  CHECK(deck.step_factor == Approx(1.0 / 2));  // 3*1/6, to rounding
  CHECK(deck.warnings.empty());
}

TEST_CASE("dyna parameters: of two values the first counts, unless the deck says otherwise") {
  const std::string twice = "*PARAMETER\nRx,1\n*PARAMETER\nRX,2\n";
  CHECK(end_time(twice, "&x") == 1);
  CHECK(read(twice).warnings ==
        std::vector<std::string>{"A second value of the parameter 'X' (1) had no effect: line 4."});
  for (const auto& [flag, expected] : {std::pair{1, 1}, {2, 2}, {4, 2}, {5, 1}})
    CHECK(end_time("*PARAMETER_DUPLICATION\n" + std::to_string(flag) + "\n" + twice, "&x") == expected);
  CHECK_THROWS_WITH(read("*PARAMETER_DUPLICATION\n3\n" + twice),
                    "strike: the file 'a.k', line 6: the parameter 'X' is there twice: take one out.");
  CHECK(end_time("*PARAMETER_MUTABLE\nRx,1\n*PARAMETER\nRX,2\n*PARAMETER\nRX,3\n", "&x") == 3);
  CHECK(end_time("*PARAMETER_LOCAL\nRx,1\n", "&x") == 1);
}

TEST_CASE("dyna parameters: a local one is that of its file and of those it includes") {
  const ScratchFolder folder("parameters");
  const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  write("inner.k", "*PARAMETER_EXPRESSION\nRfound,x*10+y\n*PARAMETER_LOCAL\nRz,3\n");
  write("outer.k", "*PARAMETER_LOCAL\nRx,2\n*INCLUDE\n&file^ner.k\n*CONTROL_TIMESTEP\n,&x\n");
  write("deck.k",
        "*PARAMETER\nRx,1,Ry,5,Cfile,in\n*INCLUDE\nouter.k\n*PARAMETER_EXPRESSION\nRend,found+x\n"
        "*CONTROL_TERMINATION\n&end\n");
  const DynaDeck deck = read_dyna(folder / "deck.k");
  CHECK(deck.step_factor == 2);
  CHECK(deck.end_time == 26);  // 2*10 + 5, + 1
  CHECK(deck.warnings.empty());
  write("deck.k", "*PARAMETER\nRx,1,Ry,5,Cfile,in\n*INCLUDE\nouter.k\n*CONTROL_TERMINATION\n&z\n");
  CHECK_THROWS_WITH(read_dyna(folder / "deck.k"),
                    ContainsSubstring("line 6: ENDTIM '&z' has no value, because parameter 'Z' is not defined above"));
}

TEST_CASE("dyna parameters: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.k', line ") && ContainsSubstring(sentence));
  };
  refused("*PARAMETER\nx,1\n", "line 2: the parameter 'x' has no type or no name: write R, I or C, and a name");
  refused("*PARAMETER\nRtime,1\n", "line 2: the parameter 'Rtime' has no type or no name");
  refused("*PARAMETER\nR2,1\n", "has no type or no name");
  refused("*PARAMETER\nRx,\n", "line 2: the parameter 'X' has no value, because it ends where");
  refused("*PARAMETER\nRx,y\n", "the parameter 'X' has no value, because parameter 'Y' is not defined above");
  refused("*PARAMETER_EXPRESSION\nRx,1/\n          0\n*END\n",
          "line 2: the parameter 'X' has no value, because it divides by 0");
  refused("*PARAMETER\nIx,1e16\n", "is larger than 9e15: make it real");
  refused("*PARAMETER_DUPLICATION\n6\n", "DFLAG 6 is none: give 1 to 5.");
  refused("*PARAMETER\nCx,a\n*NODE\n&x,0\n",
          "line 4: the number of a node '&x' has no value, because parameter 'X' is the text 'a'");
  refused("*PARAMETER\nRx,1.5\n*NODE\n&x,0\n", "line 4: the number of a node '&x' is 1.5, which is no whole number");
  refused("*PARAMETER\nIx,-1\n*NODE\n&x,0\n", "line 4: the number of a node -1 is out of bounds");
  refused("*NODE\n1,&x\n", "line 2: the coordinate '&x' has no value, because parameter 'X' is not defined above");
  std::string names;
  for (int i = 0; i < 1000; ++i) names += "&x";
  refused("*PARAMETER\nCx," + std::string(1000, 'a') + "\n*" + names + "\n", "line 3: '*&x&x&x");
  refused("*PARAMETER\nCx," + std::string(1000, 'a') + "\n*" + names + "\n", "is longer than 10,000 characters");
}
