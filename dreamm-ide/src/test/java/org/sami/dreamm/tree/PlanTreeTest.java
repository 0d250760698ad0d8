package org.sami.dreamm.tree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.dreamm.context.LibraryProject;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.tree.TreeItem.Kind;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.Usages;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.testcase.TestCaseRunner;

class PlanTreeTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Project LIBRARY = LibraryProject.of(DOMAIN);

    @Test
    void everyPlanStandsInTheTreeOnceAndFoldersOfOneLabelAreOne() {
        TreeItem root = PlanTree.of(LIBRARY);

        assertThat(below(root, Kind.PLAN))
                .containsExactlyInAnyOrderElementsOf(
                        LIBRARY.plans().stream().map(Plan::id).toList());
        assertThat(root.children().stream()
                        .filter(item -> item.kind() == Kind.FOLDER)
                        .map(TreeItem::title))
                .doesNotHaveDuplicates();
    }

    @Test
    void plansThatTheTreeLeavesOutStandAtItsEnd() {
        List<MissionTreeNode> one = List.of(new MissionTreeNode("", Optional.of("station-keep"), List.of()));

        TreeItem root = PlanTree.of(LIBRARY.withMissionTree(one));

        assertThat(below(root, Kind.PLAN)).startsWith("station-keep", "clv").hasSameSizeAs(LIBRARY.plans());
    }

    @Test
    void withoutATreeOfItsOwnThePlansOrderIsMovedAndUndone() {
        ProjectDocument document =
                new ProjectDocument(DOMAIN.vocabulary(), LIBRARY.withMissionTree(List.of()), Optional.empty());
        String first = document.project().plans().get(0).id();

        document.apply(PlanTree.move(document.project(), plan(document, first), List.of(), 1));

        assertThat(document.project().plans().get(1).id()).isEqualTo(first);
        assertThat(document.project().missionTree()).isEmpty();
        document.undo();
        assertThat(document.project().plans().get(0).id()).isEqualTo(first);
    }

    @Test
    void aPlanGoesIntoAFolderAndAFoldersPlansStayWhenItIsDeleted() {
        ProjectDocument document =
                new ProjectDocument(DOMAIN.vocabulary(), LIBRARY.withMissionTree(List.of()), Optional.empty());
        document.apply(PlanTree.addFolder(document.project(), "Lake"));
        int folder = document.project().plans().size();

        document.apply(PlanTree.move(document.project(), plan(document, "clv"), List.of(folder), 0));

        TreeItem lake = PlanTree.of(document.project()).children().stream()
                .filter(item -> item.title().equals("Lake"))
                .findFirst()
                .orElseThrow();
        assertThat(lake.children()).extracting(TreeItem::plan).containsExactly("clv");
        document.apply(PlanTree.removeFolder(document.project(), lake));
        assertThat(below(PlanTree.of(document.project()), Kind.PLAN))
                .contains("clv")
                .hasSameSizeAs(LIBRARY.plans());
    }

    @Test
    void aPlanIsRenamedWhereverItIsRun() {
        ProjectDocument document = new ProjectDocument(DOMAIN.vocabulary(), LIBRARY, Optional.empty());
        Plan run = LIBRARY.plans().stream()
                .flatMap(p -> p.places().stream())
                .flatMap(p -> p.subMissions().stream())
                .findFirst()
                .flatMap(sub -> LIBRARY.plan(sub.plan()))
                .orElseThrow();

        document.apply(Renaming.plan(LIBRARY, run).edit().apply(List.of("Another name", "another-id")));

        assertThat(document.plan("another-id").orElseThrow().name()).isEqualTo("Another name");
        assertThat(new ProjectSearch(document.project(), DOMAIN.vocabulary()).find("another-id sub-mission"))
                .isNotEmpty();
        document.undo();
        assertThat(document.project()).isEqualTo(LIBRARY);
    }

    @Test
    void eventsAndInterruptsOfAVertexAreRenamedWhereverTheyAreSpokenOf() {
        ProjectDocument document = new ProjectDocument(DOMAIN.vocabulary(), LIBRARY, Optional.empty());
        Renaming stop = Renaming.vertex(LIBRARY, LIBRARY.plan("station-keep").orElseThrow(), "stop")
                .orElseThrow();
        assertThat(stop.fields())
                .containsExactly(
                        entry("Name", "Ended by button"),
                        entry("Id", "stop"),
                        entry("Event", "button"),
                        entry("Interrupt", "End station keeping"));

        document.apply(stop.edit().apply(List.of("Ended by button", "ended", "pressed", "Home now")));

        Plan plan = document.plan("station-keep").orElseThrow();
        assertThat(plan.transition("ended").orElseThrow().inputs().get(0).id()).isEqualTo("pressed");
        Usages usages = new Usages(document.project());
        assertThat(usages.ofInterrupt("Home now"))
                .as("the event and its test case")
                .hasSizeGreaterThan(1);
        assertThat(usages.ofInterrupt("End station keeping")).isEmpty();
        document.undo();
        assertThat(document.project()).isEqualTo(LIBRARY);
    }

    @Test
    void anEventsIdIsRenamedInTestCasesAndAnIdThatIsTakenIsRefused() {
        ProjectDocument document = new ProjectDocument(DOMAIN.vocabulary(), LIBRARY, Optional.empty());
        Renaming go = Renaming.vertex(LIBRARY, LIBRARY.plan("station-keep").orElseThrow(), "go")
                .orElseThrow();

        assertThat(document.apply(go.edit().apply(List.of("Go to station", "go", "ask-boats"))))
                .isInstanceOf(EditResult.Refused.class);
        document.apply(go.edit().apply(List.of("Go to station", "go", "drive")));

        TestCaseRunner runner = new TestCaseRunner(document.project(), DOMAIN.vocabulary());
        Plan plan = document.plan("station-keep").orElseThrow();
        assertThat(plan.testCases())
                .isNotEmpty()
                .allMatch(test -> runner.run(plan, test).isEmpty());
    }

    @Test
    void tasksStandInTheTreeAndAreRenamedWithSubMissions() {
        Plan child = new PlanBuilder("child").start("c").end("d").build();
        Plan parent = new PlanBuilder("parent")
                .start("a")
                .sub("a", "child")
                .task(new TaskSpec("look", "Camera", Map.of()))
                .transition("t")
                .in("a", "t", new InRequirement(TokenKind.TASK, Match.AT_LEAST, 1, "look"))
                .build();
        Project project = new Project("p", "", "crw", List.of(), List.of(), List.of(parent, child));
        ProjectDocument document = new ProjectDocument(DOMAIN.vocabulary(), project, Optional.empty());
        assertThat(below(PlanTree.of(project), Kind.TASK)).containsExactly("parent");

        document.apply(Renaming.task(project, "parent", "look").edit().apply(List.of("photo")));
        document.apply(Renaming.subMission(project, parent, "a.sub0", child)
                .edit()
                .apply(List.of("Gather", "gather", "team")));

        Plan renamed = document.plan("parent").orElseThrow();
        assertThat(renamed.inEdges().get(0).requirements().get(0).task()).isEqualTo("photo");
        assertThat(renamed.places().get(0).subMissions().get(0).id()).isEqualTo("team");
        assertThat(renamed.places().get(0).subMissions().get(0).plan()).isEqualTo("gather");
        assertThat(document.plan("gather").orElseThrow().name()).isEqualTo("Gather");
    }

    @Test
    void theSearchFindsNamesEventsVariablesRequirementsAndNotes() {
        ProjectSearch search = new ProjectSearch(LIBRARY, DOMAIN.vocabulary());

        assertThat(search.find("compare distance")).anyMatch(hit -> hit.plan().equals("station-keep"));
        assertThat(search.find("StartProxyTimer"))
                .anyMatch(hit -> !hit.element().isEmpty());
        assertThat(search.find("proxy timer expired")).as("labels").isNotEmpty();
        assertThat(search.find("take all relevant")).isNotEmpty();
        assertThat(search.find("@")).anyMatch(hit -> hit.detail().startsWith("variable"));
        assertThat(search.find("nothing says this")).isEmpty();
        assertThat(search.find("  ")).isEmpty();
    }

    @Test
    void anIdIsMadeOfAName() {
        assertThat(TreeCommands.idOf("Connect & Station Keep!")).isEqualTo("connect-station-keep");
    }

    private static TreeItem plan(ProjectDocument document, String id) {
        return PlanTree.of(document.project()).children().stream()
                .filter(item -> item.plan().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private static List<String> below(TreeItem item, Kind kind) {
        return java.util.stream.Stream.concat(
                        java.util.stream.Stream.of(item)
                                .filter(i -> i.kind() == kind)
                                .map(TreeItem::plan),
                        item.children().stream().flatMap(child -> below(child, kind).stream()))
                .toList();
    }
}
