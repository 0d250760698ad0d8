package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.event.Allocation;
import org.sami.crw.event.PathOption;
import org.sami.crw.handler.EventCatalogue.Check;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** What the operator is asked, what the answers do, and which answers are refused. */
final class OperatorEventCases {
    private static final GeoPoint SPOT = PlanScene.at(20, 20);
    private static final GeoArea FIELD =
            new GeoArea(List.of(PlanScene.at(0, 0), PlanScene.at(50, 0), PlanScene.at(50, 50)), List.of());
    private static final RecordValue FIRST_WAY = way(PlanScene.at(10, 10));
    private static final RecordValue SECOND_WAY = way(PlanScene.at(30, 10));
    private static final RecordValue SHORT = allocation("short", PlanScene.at(10, 10));
    private static final RecordValue LONG = allocation("long", PlanScene.at(90, 10));

    private OperatorEventCases() {}

    static void add(EventCatalogue catalogue) {
        boats(catalogue);
        options(catalogue);
        places(catalogue);
        approval(catalogue);
        approvalOfBoats(catalogue);
        variables(catalogue);
    }

    private static void boats(EventCatalogue catalogue) {
        catalogue.shows(
                "OperatorSelectBoat",
                Seen.AS_A_DECISION,
                "the entering boats are offered, one of them is to be chosen; two, or a stranger, are refused",
                () -> {
                    PlanScene scene = selectBoat();
                    assertThat(scene.decision().question())
                            .isEqualTo(new Question.ChooseProxies(List.of("boat-1", "boat-2", "boat-3"), 1, 1));
                    scene.assertRefused(new Answer.Proxies(List.of("boat-1", "boat-2")), "2 are chosen");
                    scene.assertRefused(new Answer.Proxies(List.of("ghost")), "ghost");
                    scene.assertRefused(new Answer.YesNo(true), "a choice of robots is expected, not yes");
                });
        catalogue.shows("OperatorSelectsBoat", Seen.IN_THE_MARKING, "the chosen boat moves on, the others stay", () -> {
            PlanScene scene = selectBoat();
            scene.answer(new Answer.Proxies(List.of("boat-2")));
            assertThat(scene.marking(PlanScene.MISSION, "chosen")).containsExactly(PlanScene.boat("boat-2"));
            assertThat(scene.marking(PlanScene.MISSION, "ask"))
                    .contains(PlanScene.boat("boat-1"), PlanScene.boat("boat-3"));
        });
        catalogue.shows(
                "OperatorSelectBoatList",
                Seen.AS_A_DECISION,
                "the entering boats are offered, any number of them may be chosen; nobody keeps the question open",
                () -> {
                    PlanScene scene = selectBoats();
                    assertThat(((Question.ChooseProxies) scene.decision().question()).max())
                            .isGreaterThan(3);
                    scene.answer(new Answer.Proxies(List.of()));
                    assertThat(scene.notes()).anyMatch(note -> note.contains("stays open"));
                    assertThat(scene.decision().type()).isEqualTo("OperatorSelectBoatList");
                });
        catalogue.shows(
                "OperatorSelectsBoatList", Seen.IN_THE_MARKING, "the chosen boats move on, the others stay", () -> {
                    PlanScene scene = selectBoats();
                    scene.answer(new Answer.Proxies(List.of("boat-3", "boat-1")));
                    assertThat(scene.marking(PlanScene.MISSION, "chosen"))
                            .containsExactlyInAnyOrder(PlanScene.boat("boat-1"), PlanScene.boat("boat-3"));
                });
        Check asked = () -> {
            PlanScene scene = selectId();
            assertThat(((Question.ChooseOption) scene.decision().question()).options())
                    .containsExactly(boatId("red"), boatId("green"));
            scene.assertRefused(new Answer.Option(2), "from 0 to 1 is expected, not option 2");
            scene.assertRefused(new Answer.Rejected(), "one of the options is expected, not a rejection");
        };
        catalogue.shows(
                "OperatorSelectBoatId", Seen.AS_A_DECISION, "the ids that variables in scope hold are offered", asked);
        catalogue.shows(
                "OperatorSelectsBoatId", Seen.IN_THE_MARKING, "the mission goes on, the id is in the variable", () -> {
                    PlanScene scene = selectId();
                    scene.answer(new Answer.Option(1));
                    scene.untilGeneric("chosen");
                    assertThat(scene.variable("@id")).isEqualTo(boatId("green"));
                });
    }

    private static void options(EventCatalogue catalogue) {
        catalogue.shows(
                "OperatorAllocationOptions",
                Seen.AS_A_DECISION,
                "the allocations are offered in their order; one that is not there is refused",
                () -> {
                    PlanScene scene = allocations();
                    assertThat(((Question.ChooseOption) scene.decision().question()).options())
                            .containsExactly(SHORT, LONG);
                    scene.assertRefused(new Answer.Option(2), "from 0 to 1 is expected, not option 2");
                });
        catalogue.shows(
                "OperatorAcceptedAllocation",
                Seen.IN_THE_MARKING,
                "the boats move on; the accepted allocation and its paths are in the variables",
                () -> {
                    PlanScene scene = allocations();
                    scene.answer(new Answer.Option(1));
                    scene.untilBoat("boat-1", "accepted");
                    assertThat(scene.variable("@allocation")).isEqualTo(LONG);
                    assertThat(scene.variable("@paths"))
                            .isEqualTo(LONG.field("paths").orElseThrow());
                });
        catalogue.shows(
                "OperatorRejectedAllocation", Seen.IN_THE_MARKING, "the boats go where a rejection leads", () -> {
                    PlanScene scene = allocations();
                    scene.answer(new Answer.Rejected());
                    scene.untilBoat("boat-1", "rejected");
                });
        catalogue.shows(
                "OperatorPathOptions",
                Seen.AS_A_DECISION,
                "the sets of paths are offered in their order; one that is not there is refused",
                () -> {
                    PlanScene scene = ways();
                    assertThat(((Question.ChooseOption) scene.decision().question()).options())
                            .containsExactly(FIRST_WAY, SECOND_WAY);
                    scene.assertRefused(new Answer.Option(-1), "not option -1");
                });
        catalogue.shows(
                "OperatorAcceptsPath",
                Seen.IN_THE_MARKING,
                "the boats move on, the accepted paths are in the variable",
                () -> {
                    PlanScene scene = ways();
                    scene.answer(new Answer.Option(1));
                    scene.untilBoat("boat-1", "accepted");
                    assertThat(scene.variable("@paths"))
                            .isEqualTo(SECOND_WAY.field("paths").orElseThrow());
                });
        catalogue.shows("OperatorRejectsPath", Seen.IN_THE_MARKING, "the boats go where a rejection leads", () -> {
            PlanScene scene = ways();
            scene.answer(new Answer.Rejected());
            scene.untilBoat("boat-1", "rejected");
        });
    }

    private static void places(EventCatalogue catalogue) {
        catalogue.shows(
                "OperatorCreateArea",
                Seen.AS_A_DECISION,
                "an area is asked for; a point, or nothing, is refused",
                () -> {
                    PlanScene scene = create("OperatorCreateArea", "OperatorCreatedArea", "area", "area");
                    scene.assertRefused(fields("area", SPOT), "'area' needs a value of type area");
                    scene.assertRefused(new Answer.Fields(Map.of()), "'area' is missing");
                });
        catalogue.shows("OperatorCreatedArea", Seen.IN_THE_MARKING, "the area is in the variable", () -> {
            PlanScene scene = create("OperatorCreateArea", "OperatorCreatedArea", "area", "area");
            scene.answer(fields("area", FIELD));
            scene.untilGeneric("created");
            assertThat(scene.variable("@it")).isEqualTo(FIELD);
        });
        catalogue.shows(
                "OperatorCreateLocations", Seen.AS_A_DECISION, "locations are asked for; an area is refused", () -> {
                    PlanScene scene =
                            create("OperatorCreateLocations", "OperatorCreatesLocations", "locations", "list<point>");
                    scene.assertRefused(fields("locations", FIELD), "locations");
                });
        catalogue.shows(
                "OperatorCreatesLocations", Seen.IN_THE_MARKING, "the locations are in the variable in order", () -> {
                    PlanScene scene =
                            create("OperatorCreateLocations", "OperatorCreatesLocations", "locations", "list<point>");
                    ListValue marked = new ListValue(List.of(SPOT, PlanScene.at(5, 5)));
                    scene.answer(fields("locations", marked));
                    scene.untilGeneric("created");
                    assertThat(scene.variable("@it")).isEqualTo(marked);
                });
    }

    private static void approval(EventCatalogue catalogue) {
        catalogue.shows(
                "OperatorApprove",
                Seen.AS_A_DECISION,
                "the plan's question is asked; what is neither yes nor no is refused",
                () -> {
                    PlanScene scene = approve();
                    assertThat(scene.decision().prompt()).isEqualTo("Is the water calm?");
                    scene.assertRefused(new Answer.Option(0), "yes or no is expected");
                });
        catalogue.shows("YesOption", Seen.IN_THE_MARKING, "yes leads where it leads", () -> {
            PlanScene scene = approve();
            scene.answer(new Answer.YesNo(true));
            scene.untilGeneric("yes");
        });
        catalogue.shows("NoOption", Seen.IN_THE_MARKING, "no leads where it leads", () -> {
            PlanScene scene = approve();
            scene.answer(new Answer.YesNo(false));
            scene.untilGeneric("no");
        });
    }

    private static void approvalOfBoats(EventCatalogue catalogue) {
        catalogue.shows(
                "OperatorApproveBoats", Seen.AS_A_DECISION, "the question is asked of the boats that entered", () -> {
                    PlanScene scene = approveBoats();
                    assertThat(scene.decision().prompt()).isEqualTo("Go on?");
                    scene.assertRefused(new Answer.Option(0), "yes or no is expected");
                });
        catalogue.shows("YesOptionForBoats", Seen.IN_THE_MARKING, "the boats of the question move on", () -> {
            PlanScene scene = approveBoats();
            scene.answer(new Answer.YesNo(true));
            scene.untilBoat("boat-1", "yes");
            scene.untilBoat("boat-2", "yes");
        });
        catalogue.shows("NoOptionForBoats", Seen.IN_THE_MARKING, "the boats of the question move elsewhere", () -> {
            PlanScene scene = approveBoats();
            scene.answer(new Answer.YesNo(false));
            scene.untilBoat("boat-2", "no");
        });
    }

    private static PlanScene approveBoats() {
        return new PlanScene(
                new PlanSketch()
                        .asks("ask", "OperatorApproveBoats", "question", new TextValue("Go on?"))
                        .on("ask", "YesOptionForBoats", "yes")
                        .on("ask", "NoOptionForBoats", "no"),
                2);
    }

    private static void variables(EventCatalogue catalogue) {
        catalogue.shows(
                "DefineVariables",
                Seen.AS_A_DECISION,
                "a value of its type is asked for each variable; another type, or one missing, is refused",
                () -> {
                    PlanScene scene = define();
                    assertThat(items(scene.decision())).containsExactly("@spacing", "@spot");
                    scene.assertRefused(
                            fields("@spacing", SPOT, "@spot", SPOT), "'@spacing' needs a value of type real");
                    scene.assertRefused(fields("@spot", SPOT), "@spacing");
                    scene.assertRefused(fields("@spacing", new RealValue(3), "@spot", SPOT, "@other", SPOT), "@other");
                });
        catalogue.shows(
                "DefinedVariablesReceived", Seen.IN_THE_MARKING, "the mission goes on, both variables are set", () -> {
                    PlanScene scene = define();
                    scene.answer(fields("@spacing", new RealValue(7), "@spot", SPOT));
                    scene.untilGeneric("defined");
                    assertThat(scene.variable("@spacing")).isEqualTo(new RealValue(7));
                    assertThat(scene.variable("@spot")).isEqualTo(SPOT);
                });
        catalogue.shows(
                "RedefineVariables",
                Seen.AS_A_DECISION,
                "a new value is asked for, with the present one shown; another type is refused",
                () -> {
                    PlanScene scene = redefine();
                    Question.FillIn question =
                            (Question.FillIn) scene.decision().question();
                    assertThat(question.items().get(0).defaultValue()).contains(new RealValue(4));
                    scene.assertRefused(fields("@spacing", new TextValue("far")), "@spacing");
                });
        catalogue.shows(
                "RedefinedVariablesReceived",
                Seen.IN_THE_MARKING,
                "the mission goes on, the variable has its new value",
                () -> {
                    PlanScene scene = redefine();
                    scene.answer(fields("@spacing", new RealValue(9)));
                    scene.untilGeneric("defined");
                    assertThat(scene.variable("@spacing")).isEqualTo(new RealValue(9));
                });
        catalogue.shows(
                "SelectVariable",
                Seen.AS_A_DECISION,
                "the variables of the asked type are offered, and no others",
                () -> {
                    PlanScene scene = select();
                    assertThat(((Question.ChooseOption) scene.decision().question()).options())
                            .containsExactly(new VariableReference("@north"), new VariableReference("@south"));
                    scene.assertRefused(new Answer.Option(2), "from 0 to 1 is expected, not option 2");
                });
        catalogue.shows(
                "VariableSelected",
                Seen.IN_THE_MARKING,
                "the mission goes on, the chosen variable's name is in the variable",
                () -> {
                    PlanScene scene = select();
                    scene.answer(new Answer.Option(1));
                    scene.untilGeneric("selected");
                    assertThat(scene.variable("@which")).isEqualTo(new VariableReference("@south"));
                });
    }

    private static PlanScene selectBoat() {
        return new PlanScene(
                new PlanSketch().asks("ask", "OperatorSelectBoat").on("ask", "OperatorSelectsBoat", "chosen"), 3);
    }

    private static PlanScene selectBoats() {
        return new PlanScene(
                new PlanSketch().asks("ask", "OperatorSelectBoatList").on("ask", "OperatorSelectsBoatList", "chosen"),
                3);
    }

    private static PlanScene selectId() {
        PlanSketch plan = new PlanSketch().variable("@id", "BoatId");
        for (String name : List.of("red", "green")) {
            plan.variable("@" + name, TypeNames.parse("BoatId").orElseThrow(), "BoatId", boatId(name));
        }
        return new PlanScene(
                plan.asks("ask", "OperatorSelectBoatId")
                        .on("ask", "OperatorSelectsBoatId", "chosen")
                        .writing("selectedId", "@id"),
                0);
    }

    private static PlanScene allocations() {
        return new PlanScene(
                new PlanSketch()
                        .variable("@allocation", "Allocation")
                        .variable("@paths", "map<proxy,path>")
                        .asks("ask", "OperatorAllocationOptions", "options", new ListValue(List.of(SHORT, LONG)))
                        .on("ask", "OperatorAcceptedAllocation", "accepted")
                        .writing("allocation", "@allocation")
                        .writing("paths", "@paths")
                        .on("ask", "OperatorRejectedAllocation", "rejected"),
                1);
    }

    private static PlanScene ways() {
        return new PlanScene(
                new PlanSketch()
                        .variable("@paths", "map<proxy,path>")
                        .asks("ask", "OperatorPathOptions", "options", new ListValue(List.of(FIRST_WAY, SECOND_WAY)))
                        .on("ask", "OperatorAcceptsPath", "accepted")
                        .writing("paths", "@paths")
                        .on("ask", "OperatorRejectsPath", "rejected"),
                1);
    }

    private static PlanScene create(String output, String input, String field, String type) {
        return new PlanScene(
                new PlanSketch()
                        .variable("@it", type)
                        .asks("ask", output)
                        .on("ask", input, "created")
                        .writing(field, "@it"),
                0);
    }

    private static PlanScene approve() {
        return new PlanScene(
                new PlanSketch()
                        .asks("ask", "OperatorApprove", "question", new TextValue("Is the water calm?"))
                        .on("ask", "YesOption", "yes")
                        .on("ask", "NoOption", "no"),
                0);
    }

    private static PlanScene define() {
        ListValue both = new ListValue(List.of(new VariableReference("@spacing"), new VariableReference("@spot")));
        return new PlanScene(
                new PlanSketch()
                        .variable("@spacing", "real")
                        .variable("@spot", "point")
                        .variable("@other", "point")
                        .asks("ask", "DefineVariables", "variables", both)
                        .on("ask", "DefinedVariablesReceived", "defined"),
                0);
    }

    private static PlanScene redefine() {
        return new PlanScene(
                new PlanSketch()
                        .variable("@spacing", TypeNames.parse("real").orElseThrow(), "real", new RealValue(4))
                        .asks("ask", "RedefineVariables", "variable", new VariableReference("@spacing"))
                        .on("ask", "RedefinedVariablesReceived", "defined"),
                0);
    }

    private static PlanScene select() {
        PlanSketch plan = new PlanSketch().variable("@which", "variable").variable("@width", "real");
        for (String name : List.of("@north", "@south")) {
            plan.variable(name, TypeNames.parse("point").orElseThrow(), "point", SPOT);
        }
        return new PlanScene(
                plan.asks("ask", "SelectVariable", "variableClass", new TextValue("point"))
                        .on("ask", "VariableSelected", "selected")
                        .writing("variable", "@which"),
                0);
    }

    private static List<String> items(Decision decision) {
        return ((Question.FillIn) decision.question())
                .items().stream().map(Question.Item::key).toList();
    }

    private static Answer.Fields fields(Object... pairs) {
        Map<String, Value> values = new LinkedHashMap<>();
        for (int i = 0; i < pairs.length; i += 2) {
            values.put((String) pairs[i], (Value) pairs[i + 1]);
        }
        return new Answer.Fields(values);
    }

    private static RecordValue boatId(String name) {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("name", new TextValue(name));
        fields.put("color", new TextValue("#ffce00"));
        fields.put("server", new TextValue("127.0.0.1:11411"));
        fields.put("imageStorageDirectory", new TextValue(""));
        return new RecordValue("BoatId", fields);
    }

    private static RecordValue way(GeoPoint to) {
        return new PathOption(Map.of("boat-1", new GeoPath(List.of(to))), 10, 10, "Shortest path", "").toValue();
    }

    private static RecordValue allocation(String method, GeoPoint to) {
        return new Allocation(Map.of("boat-1", new GeoPath(List.of(to))), 10, 10, method).toValue();
    }
}
