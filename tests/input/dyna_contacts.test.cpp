#include <limits>
#include <string>

#include <strike/input/dyna.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

using namespace strike;
using decks::read;

namespace {

/// Two shells of parts 1 and 2, a third part without cells, and sets.
const std::string mesh = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
6,2,1,0
*ELEMENT_SHELL
1,1,1,2,3,4
2,2,2,5,6,3
*PART
empty
3
*SET_PART_LIST
5
1,3
*SET_PART_ADD
6
5
*SET_NODE_LIST
4
1,6
*SET_SHELL
8
2
*SET_SEGMENT
9
1,2,3
)";

}  // namespace

TEST_CASE("dyna contacts: each kind, with its options in any order") {
  const std::pair<const char*, const char*> keywords[] = {
      {"AUTOMATIC_SINGLE_SURFACE", "SINGLE_SURFACE"},
      {"AUTOMATIC_GENERAL", "GENERAL"},
      {"AUTOMATIC_SURFACE_TO_SURFACE", "SURFACE_TO_SURFACE"},
      {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE"},
      {"AUTOMATIC_NODES_TO_SURFACE", "NODES_TO_SURFACE"},
      {"SURFACE_TO_SURFACE", "SURFACE_TO_SURFACE"},
      {"ONE_WAY_SURFACE_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE"},
      {"NODES_TO_SURFACE", "NODES_TO_SURFACE"},
      {"SINGLE_SURFACE", "SINGLE_SURFACE"},
      {"TIED_NODES_TO_SURFACE", "TIED_NODES_TO_SURFACE"},
      {"TIED_NODES_TO_SURFACE_OFFSET", "TIED_NODES_TO_SURFACE_OFFSET"},
      {"TIED_SURFACE_TO_SURFACE", "TIED_SURFACE_TO_SURFACE"},
      {"TIED_SURFACE_TO_SURFACE_OFFSET", "TIED_SURFACE_TO_SURFACE_OFFSET"},
      {"TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"}};
  for (const auto& [keyword, kind] : keywords)
    for (const bool mpp : {false, true})
      for (const bool title_last : {false, true}) {
        std::string text = "*CONTACT_" + std::string(keyword);
        text += !mpp ? "_ID" : title_last ? "_MPP_ID" : "_ID_MPP";
        text += "\n        17one on another\n";
        if (mpp) text += "         0       200\n$ more\n&\n";
        text += "         1         2         3         3\n       0.3\n";
        const DynaDeck deck = read(mesh + text);
        REQUIRE(deck.contacts.size() == 1);
        const ContactCard& contact = deck.contacts[0];
        CHECK(contact.kind == kind);
        CHECK(contact.automatic == std::string(keyword).starts_with("AUTOMATIC_"));
        CHECK(contact.is_tied() == std::string(keyword).starts_with("TIED_"));
        CHECK(contact.number == 17);
        CHECK(contact.title == "one on another");
        CHECK(contact.slave.parts == std::vector<FileNumber>{1});
        CHECK(contact.master.parts == std::vector<FileNumber>{2});
        CHECK(contact.static_friction == 0.3);
        CHECK(deck.warnings.size() == (mpp ? 2 : 0));
      }
}

TEST_CASE("dyna contacts: eroding contacts have a card of their own") {
  const DynaDeck deck = read(mesh + R"(*CONTACT_ERODING_SURFACE_TO_SURFACE
1,2,3,3


         0         1         1
         2       0.2
*CONTACT_ERODING_SINGLE_SURFACE
0
*CONTACT_ERODING_NODES_TO_SURFACE_TITLE
by its title alone
4,2,4,3

)");
  REQUIRE(deck.contacts.size() == 3);
  CHECK(deck.contacts[0].kind == "ERODING_SURFACE_TO_SURFACE");
  CHECK(deck.contacts[0].is_eroding());
  CHECK(deck.contacts[0].exposes);
  CHECK(deck.contacts[0].soft == 2);
  CHECK(deck.contacts[0].soft_scale == 0.2);
  CHECK(!deck.contacts[1].exposes);
  CHECK(deck.contacts[2].title == "by its title alone");
  CHECK(deck.contacts[2].number == 0);
  CHECK(deck.contacts[2].slave.nodes == std::vector<Index>{0, 5});
  CHECK(deck.warnings.empty());
}

TEST_CASE("dyna contacts: values of all cards, and the defaults of zeros and blanks") {
  const DynaDeck deck = read(mesh + R"(*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE
$#    ssid      msid     sstyp     mstyp    sboxid    mboxid       spr       mpr
         1         2         3         3         0         0         1         1
$#      fs        fd        dc        vc       vdc    penchk        bt        dt
       0.3       0.2       0.1       0.0      20.0         0      0.01       2.0
$#     sfs       sfm       sst       mst      sfst      sfmt       fsf       vsf
       0.5       2.0       0.7       0.8       0.9       1.1       1.0       1.0
$#    soft    sofscl    lcidab    maxpar     sbopt     depth     bsort    frcfrq
         1      0.25         0     1.025         2         5         0         1
$#  penmax    thkopt    shlthk     snlog      isym     i2d3d    sldthk    sldstf
       0.0         0         0         0         0         0       0.0       0.0
$#    igap    ignore    dprfac    dtstif                        flangl   cid_rcf
         1         1       0.0       0.0                           0.0         0
*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE
1,2,3,3
0,0,0,0,0,0,0,1e20
0,0,0,0,0,0,0,0
0,0,0,0,0,0,0,0
*CONTACT_AUTOMATIC_SINGLE_SURFACE
*CONTACT_AUTOMATIC_SINGLE_SURFACE
0,0,0,0,7
-1.,.3,.4,.5,0,1
0,0,0,0,0,0,.5,.6
0,0,3,1.1,3,0,50,10
1.,1,1,1,1,1,1,1
2,0,1,1,0,0,1,1
1,1,1,1,1,1,1,1
1,1,1,1,2,1,1,1
.1
)");
  REQUIRE(deck.contacts.size() == 4);
  const ContactCard& all = deck.contacts[0];
  CHECK(all.dynamic_friction == 0.2);
  CHECK(all.damping == 20);
  CHECK(all.birth == 0.01);
  CHECK(all.death == 2);
  CHECK(all.slave.stiffness == 0.5);
  CHECK(all.master.stiffness == 2);
  CHECK(all.slave.thickness == 0.7);
  CHECK(all.master.thickness == 0.8);
  CHECK(all.slave.thickness_scale == 0.9);
  CHECK(all.master.thickness_scale == 1.1);
  CHECK(all.soft == 1);
  CHECK(all.soft_scale == 0.25);
  CHECK(all.depth == 5);
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    const ContactCard& none = deck.contacts[i];
    CHECK(none.static_friction == 0);
    CHECK(none.birth == 0);
    CHECK(none.death == std::numeric_limits<double>::infinity());
    CHECK(none.slave.stiffness == 1);
    CHECK(none.master.thickness == 0);
    CHECK(none.master.thickness_scale == 1);
    CHECK(none.soft == 0);
    CHECK(none.soft_scale == 0.1);
    CHECK(none.depth == 2);
    CHECK(!none.exposes);
  }
  CHECK(deck.contacts[3].dynamic_friction == 0);  // that of the parts counts
  // SBOXID, FS, VC, PENCHK, FSF, VSF; LCIDAB, MAXPAR, SBOPT, BSORT, FRCFRQ; all of B; IGAP, DPRFAC, DTSTIF, FLANGL,
  // CID_RCF; all of D and E; and what follows
  CHECK(deck.warnings.size() == 6 + 5 + 8 + 5 + 8 + 8 + 1);
}

TEST_CASE("dyna contacts: what a side may name") {
  const auto side = [](const std::string& number, const std::string& kind) {
    return read("*CONTACT_SURFACE_TO_SURFACE\n" + number + ",0," + kind + "\n" + mesh).contacts[0].slave;
  };
  CHECK(side("9", "0").segments == Cells<4>{{0, 1, 2, 2}});
  CHECK(side("8", "1").segments == Cells<4>{{1, 4, 5, 2}});
  CHECK(side("5", "2").parts == std::vector<FileNumber>{1, 3});
  CHECK(side("6", "2").parts == std::vector<FileNumber>{1, 3});
  CHECK(side("2", "3").parts == std::vector<FileNumber>{2});
  CHECK(side("4", "4").nodes == std::vector<Index>{0, 5});
  CHECK(side("5", "6").parts == std::vector<FileNumber>{2});  // all but those
  for (const auto& all : {side("0", "5"), side("4", "5"), side("0", "2"), side("0", "0")}) {
    CHECK(all.parts.empty());
    CHECK(all.nodes.empty());
    CHECK(all.segments.empty());
  }
}

TEST_CASE("dyna contacts: parameters, and what is wrong") {
  const DynaDeck deck = read("*PARAMETER\nIone,1\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP\n0\n&one,2,3,3\n" + mesh);
  CHECK(deck.contacts[0].slave.parts == std::vector<FileNumber>{1});  // no second card of MPP, but a parameter

  const auto refused = [](const std::string& text, const std::string& sentence) {
    decks::expect_refused(mesh + text, sentence);
  };
  refused("*CONTACT_TIED_NODES_TO_SURFACE\n4,0,4\n", "a tied contact names too little: give it SSID and MSID.");
  refused("*CONTACT_SURFACE_TO_SURFACE\n7,0,1\n", "line 30: the set of shells 7 is not in the file");
  refused("*SET_PART\n7\n1,2,3\n*CONTACT_SINGLE_SURFACE\n7,0,6\n", "line 33: a contact exempts all parts");
  refused("*SET_PART\n7\n1,77\n*CONTACT_SINGLE_SURFACE\n7,0,2\n", "line 31: part 77 is not in the file");
  for (const char* keyword : {"INTERIOR", "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "FORCE_TRANSDUCER_PENALTY"}) {
    const DynaDeck passed = read(mesh + "*CONTACT_" + keyword + "_ID\n1\n");
    CHECK(passed.contacts.empty());
    CHECK(passed.warnings ==
          std::vector<std::string>{"*CONTACT_" + std::string(keyword) + "_ID (1 card) was skipped: line 29."});
  }
}
