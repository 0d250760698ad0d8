package org.sami.spn.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;

/** What edits take along, tell and refuse. */
class EditTest {
    private static final ValueType TEXT = ValueType.Simple.TEXT;
    private static final FieldSource SAID = new FieldSource.FromVariable("@said");

    private static NetBuilder saying(String id) {
        return new NetBuilder(id)
                .start("start")
                .output("start", "Do", Map.of("text", SAID), Map.of())
                .end("end")
                .transition("t", "Done")
                .in("start", "t", "generic >= 1")
                .out("t", "end", "take all any");
    }

    private static EditResult.Done done(Project project, Edit edit) {
        EditResult result = edit.apply(project, TestVocabulary.TEST);
        assertThat(result).as("%s", edit).isInstanceOf(EditResult.Done.class);
        return (EditResult.Done) result;
    }

    private static String refused(Project project, Edit edit) {
        EditResult result = edit.apply(project, TestVocabulary.TEST);
        assertThat(result).as("%s", edit).isInstanceOf(EditResult.Refused.class);
        return ((EditResult.Refused) result).message();
    }

    private static Plan plan(EditResult.Done done, String id) {
        return done.changed().plan(id).orElseThrow();
    }

    @Test
    void vertexTakesEdgesLayoutOrderAndTestStepsAlong() {
        Plan drawn = saying("p").order("start", "t").build();
        Plan plan = drawn.withLayout(Map.of("t", new LayoutPoint(1, 2), "end", new LayoutPoint(3, 4)))
                .withTestCases(List.of(new TestCase(
                        "runs",
                        List.of(),
                        List.of(
                                new TestStep.ExpectTokens("end", 1, List.of(), List.of()),
                                new TestStep.Occur("Done", "start.Do", List.of(), List.of(), Map.of())))));
        Project project = NetBuilder.project(plan);

        EditResult.Done withoutT = done(project, new RemoveElements("p", Set.of("t")));
        assertThat(plan(withoutT, "p").inEdges()).isEmpty();
        assertThat(plan(withoutT, "p").outEdges()).isEmpty();
        assertThat(plan(withoutT, "p").layout()).containsOnlyKeys("end");
        assertThat(plan(withoutT, "p").place("start").orElseThrow().transitionOrder())
                .isEmpty();
        assertThat(withoutT.remarks()).hasSize(2).allMatch(told -> told.contains("went along"));

        EditResult.Done withoutEnd = done(project, new RemoveElements("p", Set.of("end")));
        assertThat(plan(withoutEnd, "p").testCases().get(0).steps()).hasSize(1);
        assertThat(withoutEnd.remarks()).anyMatch(told -> told.contains("Step 1 of the test case \"runs\""));
        assertThat(done(project, new RemoveElements("p", Set.of("start.Do"))).remarks())
                .singleElement()
                .asString()
                .contains("Step 2", "there is no output event start.Do");
    }

    @Test
    void startOfATestCaseLosesAPlaceThatIsGoneAndGoesWithItsLast() {
        TestStart both = new TestStart(
                new StartMarking(List.of(
                        new StartMarking.Tokens("start", 1, List.of(), List.of()),
                        new StartMarking.Tokens("side", 1, List.of(), List.of()))),
                Map.of());
        TestStart one = new TestStart(
                new StartMarking(List.of(new StartMarking.Tokens("side", 1, List.of(), List.of()))), Map.of());
        TestCase test = new TestCase("runs", List.of(), List.of(new TestStep.ExpectEnded()));
        Project project = NetBuilder.project(saying("p")
                .places("side")
                .build()
                .withTestCases(List.of(
                        test.withStart(Optional.of(both)),
                        test.withName("later").withStart(Optional.of(one)))));

        EditResult.Done done = done(project, new RemoveElements("p", Set.of("side")));

        assertThat(plan(done, "p").testCases()).singleElement().satisfies(left -> {
            assertThat(left.name()).isEqualTo("runs");
            assertThat(left.start().orElseThrow().marking().places())
                    .extracting(StartMarking.Tokens::place)
                    .containsExactly("start");
        });
        assertThat(done.remarks())
                .anyMatch(told -> told.contains("The tokens in side went along"))
                .anyMatch(told -> told.contains("\"later\"") && told.contains("no place is left"));
    }

    @Test
    void startOfATestCaseIsSpokenOfByItsNewId() {
        TestStart start = new TestStart(
                new StartMarking(List.of(new StartMarking.Tokens("start", 1, List.of(), List.of()))), Map.of());
        Project project = NetBuilder.project(saying("p")
                .build()
                .withTestCases(List.of(new TestCase("runs", List.of(), Optional.of(start), List.of()))));

        EditResult.Done done = done(project, new RenameElement("p", "start", "begin"));

        assertThat(new Usages(done.changed()).ofElement("p", "begin"))
                .extracting(Usage::where)
                .contains("test case \"runs\", start");
    }

    @Test
    void renamedVertexIsSpokenOfByItsNewIdEverywhere() {
        Plan plan = saying("p")
                .order("start", "t")
                .build()
                .withLayout(Map.of("start", new LayoutPoint(1, 2)))
                .withTestCases(List.of(new TestCase(
                        "runs", List.of(), List.of(new TestStep.ExpectTokens("start", 1, List.of(), List.of())))));

        EditResult.Done done = done(NetBuilder.project(plan), new RenameElement("p", "start", "begin"));

        assertThat(new Usages(done.changed()).ofElement("p", "start")).isEmpty();
        assertThat(new Usages(done.changed()).ofElement("p", "begin"))
                .extracting(Usage::where)
                .containsExactly("edge", "layout", "test case \"runs\", step 1");
        assertThat(done.remarks()).isEmpty();
        assertThat(refused(NetBuilder.project(plan), new RenameElement("p", "start", "end")))
                .contains("\"p\"", "end is used already");
    }

    @Test
    void renamedVertexIsSpokenOfByItsNewIdInQueries() {
        Plan plan = saying("p")
                .build()
                .withQueries(List.of(
                        query("a", "reachable m(start.robots) >= 1 and m(\"start\".generic) = 0"),
                        query("b", "bound start"),
                        query("c", "invariant m(starting) = 0 or enabled(t) and m( start ) <= 2")));

        EditResult.Done done = done(NetBuilder.project(plan), new RenameElement("p", "start", "first-one"));

        assertThat(plan(done, "p").queries())
                .extracting(PlanQuery::text)
                .containsExactly(
                        "reachable m(first-one.robots) >= 1 and m(first-one.generic) = 0",
                        "bound first-one",
                        "invariant m(starting) = 0 or enabled(t) and m( first-one ) <= 2");
        assertThat(new Usages(done.changed()).ofElement("p", "first-one"))
                .extracting(Usage::where)
                .contains("query \"a\"", "query \"b\"", "query \"c\"");
    }

    @Test
    void queryIsKeptReplacedAndRemovedByItsName() {
        Project project = NetBuilder.project(saying("p").build());
        PlanQuery first = query("asked", "deadlock");
        PlanQuery second = query("asked", "bound start");

        Project kept = done(project, new ProjectEdit.SetQuery("p", "asked", Optional.of(first)))
                .changed();
        Project replaced = done(kept, new ProjectEdit.SetQuery("p", "asked", Optional.of(second)))
                .changed();
        Project removed = done(replaced, new ProjectEdit.SetQuery("p", "asked", Optional.empty()))
                .changed();

        assertThat(kept.plan("p").orElseThrow().queries()).containsExactly(first);
        assertThat(replaced.plan("p").orElseThrow().queries()).containsExactly(second);
        assertThat(removed).isEqualTo(project);
    }

    private static PlanQuery query(String name, String text) {
        return new PlanQuery(name, text, PlanQuery.Expected.YES);
    }

    @Test
    void renamedVariableReachesThePlansThatSeeIt() {
        Plan parent =
                saying("parent").variable("@said", TEXT).sub("start", "child").build();
        Plan hiding = saying("hiding").variable("@said", TEXT).build();
        Project project = NetBuilder.project(
                parent, saying("child").sub("start", "hiding").build(), hiding);

        EditResult.Done done = done(project, new RenameVariable(Optional.of("parent"), "@said", "@word"));

        assertThat(done.touched()).containsExactlyInAnyOrder("parent", "child");
        assertThat(new Usages(done.changed()).ofVariable(Optional.of("parent"), "@word"))
                .extracting(Usage::plan)
                .containsExactly("parent", "parent", "child");
        assertThat(done.changed().plan("hiding")).containsSame(hiding);
    }

    @Test
    void planThatOthersRunKeepsTheNameAndIsGivenTheVariable() {
        Plan child = saying("child").build();
        Plan parent =
                saying("parent").variable("@said", TEXT).sub("start", "child").build();
        Plan other =
                saying("other").variable("@said", TEXT).sub("start", "child").build();

        EditResult.Done done = done(
                NetBuilder.project(parent, other, child), new RenameVariable(Optional.of("parent"), "@said", "@word"));

        assertThat(done.changed().plan("child")).containsSame(child);
        assertThat(plan(done, "parent").places().get(0).subMissions().get(0).variables())
                .containsExactly(Map.entry("@said", "@word"));
        assertThat(done.remarks()).singleElement().asString().contains("gives @word as @said");
    }

    @Test
    void variableOfAnotherIsRenamedWhereItIsDeclared() {
        Plan parent =
                saying("parent").variable("@said", TEXT).sub("start", "child").build();
        Project project = NetBuilder.project(
                List.of(new VariableSpec("@all", TEXT, Optional.empty())),
                parent,
                saying("child").build());

        assertThat(refused(project, new RenameVariable(Optional.of("child"), "@said", "@word")))
                .contains("the variable of the plan \"parent\": rename it there");
        assertThat(refused(project, new RenameVariable(Optional.of("parent"), "@said", "word")))
                .contains("no name of a variable");
        assertThat(refused(project, new RenameVariable(Optional.empty(), "@nothing", "@word")))
                .contains("@nothing");
    }

    @Test
    void interruptIsRenamedInEveryPlanAndItsTestCases() {
        Plan plan = saying("p")
                .input("t", "Interrupt", Map.of("interruptName", new TextValue("Stop")), Map.of())
                .build()
                .withTestCases(
                        List.of(new TestCase("stops", List.of(), List.of(new TestStep.Press("Stop", List.of())))));

        EditResult.Done done = done(NetBuilder.project(plan), new RenameInterrupt("Stop", "Halt"));

        assertThat(new Usages(done.changed()).ofInterrupt("Halt")).hasSize(2);
        assertThat(new Usages(done.changed()).ofInterrupt("Stop")).isEmpty();
    }

    @Test
    void removedPlanTakesTheSubMissionsThatRunItAlongAndSaysSo() {
        Project project = NetBuilder.project(
                        saying("parent").sub("start", "child").build(),
                        saying("child").build())
                .withMissionTree(List.of(new MissionTreeNode(
                        "", Optional.of("child"), List.of(new MissionTreeNode("", Optional.of("parent"), List.of())))));

        EditResult.Done done = done(project, new ProjectEdit.RemovePlan("child"));

        assertThat(plan(done, "parent").places().get(0).subMissions()).isEmpty();
        assertThat(done.changed().missionTree())
                .extracting(MissionTreeNode::plan)
                .containsExactly(Optional.of("parent"));
        assertThat(done.remarks()).singleElement().asString().contains("\"parent\"", "start.sub0", "\"child\"");
        EditResult.Done renamed = done(project, new ProjectEdit.RenamePlan("child", "kid"));
        assertThat(new Usages(renamed.changed()).ofPlan("kid"))
                .extracting(Usage::where)
                .containsExactly("mission tree", "sub-mission");
    }

    @Test
    void pastedPartGetsItsOwnIdsAndBringsItsVariables() {
        Project project = NetBuilder.project(
                saying("a").variable("@said", TEXT).build(), saying("b").build());
        Fragment copied = Fragment.copyOf(project.plans().get(0), Set.of("start", "t"));

        EditResult.Done done = done(project, new Paste("b", copied, 0, 0));

        Plan b = plan(done, "b");
        assertThat(b.places()).extracting(p -> p.id()).containsExactly("start", "end", "start-2");
        assertThat(b.places().get(2).start()).isFalse();
        assertThat(b.places().get(2).name()).isEqualTo("start 2");
        assertThat(b.inEdges()).hasSize(2);
        assertThat(b.outEdges()).hasSize(1);
        assertThat(b.variables()).extracting(VariableSpec::name).containsExactly("@said");
        assertThat(done.remarks()).singleElement().asString().contains("@said");
    }

    @Test
    void lockedEdgesStayLockedWhateverIsRenamed() {
        Project project = NetBuilder.project(saying("p").build());
        String edge = project.plans().get(0).inEdges().get(0).id();

        Project locked =
                done(project, new EdgeEdit.SetLocked("p", Set.of(edge), true)).changed();
        Plan renamed = plan(done(locked, new RenameElement("p", "start", "begin")), "p");

        assertThat(renamed.inEdges()).extracting(InEdge::id, InEdge::locked).contains(tuple(edge, true));
        assertThat(renamed.outEdges()).extracting(OutEdge::locked).containsOnly(false);
        assertThat(refused(project, new EdgeEdit.SetLocked("p", Set.of("start"), true)))
                .contains("no edge start");
    }

    @Test
    void whatCouldNotBeSavedIsRefusedAndChangesNothing() {
        Project project = NetBuilder.project(saying("p").build());

        assertThat(refused(project, new EdgeEdit.Connect("p", "start", "end", Mode.NOMINAL)))
                .contains("both places");
        assertThat(refused(project, new EdgeEdit.Connect("p", "start", "t", Mode.NOMINAL)))
                .contains("start → t is there already");
        assertThat(refused(project, new EdgeEdit.Connect("q", "start", "t", Mode.NOMINAL)))
                .contains("no plan \"q\"");
        assertThat(refused(
                        project,
                        new FieldEdit.SetField("p", "start.Do", "speed", new FieldSource.Fixed(new TextValue("fast")))))
                .contains("speed", "start.Do", "not of its type");
        EditSequence half = new EditSequence(
                "Half",
                List.of(
                        new VertexEdit.NameVertex("p", "start", "Begin"),
                        new VertexEdit.NameVertex("p", "nowhere", "Begin")));
        assertThat(refused(project, half)).contains("nowhere");
    }

    @Test
    void nodeOfTheMissionTreeMovesWithItsChildrenButNotBelowItself() {
        MissionTreeNode leaf = new MissionTreeNode("leaf", Optional.empty(), List.of());
        MissionTreeNode folder = new MissionTreeNode("folder", Optional.empty(), List.of(leaf));
        MissionTreeNode last = new MissionTreeNode("last", Optional.empty(), List.of());
        Project project = NetBuilder.project(saying("p").build()).withMissionTree(List.of(folder, last));

        EditResult.Done done = done(project, new ProjectEdit.MoveTreeNode(List.of(0), List.of(1), 0));

        assertThat(done.changed().missionTree())
                .containsExactly(new MissionTreeNode("last", Optional.empty(), List.of(folder)));
        assertThat(refused(project, new ProjectEdit.MoveTreeNode(List.of(0), List.of(0, 0), 0)))
                .contains("below itself");
    }

    @Test
    void historyUndoesRedoesForgetsTheOldestAndKnowsWhatIsSaved() {
        Project opened = NetBuilder.project(saying("p").build());
        EditHistory history = new EditHistory(opened, TestVocabulary.TEST, 2);
        for (String name : List.of("one", "two", "three")) {
            history.apply(new VertexEdit.NameVertex("p", "start", name));
        }
        history.apply(new VertexEdit.NameVertex("p", "start", "three"));

        assertThat(history.isModified()).isTrue();
        history.markSaved();
        assertThat(history.isModified()).isFalse();
        assertThat(history.undoLabel()).contains("Name \"start\"");
        assertThat(history.undo())
                .hasValueSatisfying(done -> assertThat(done.touched()).containsExactly("p"));
        assertThat(history.isModified()).isTrue();
        assertThat(history.undo()).isPresent();
        assertThat(history.undo()).isEmpty();
        assertThat(history.project().plans().get(0).places().get(0).name()).isEqualTo("one");
        assertThat(history.redo()).isPresent();
        assertThat(history.redo()).isPresent();
        assertThat(history.redo()).isEmpty();
        assertThat(history.isModified()).isFalse();
    }
}
