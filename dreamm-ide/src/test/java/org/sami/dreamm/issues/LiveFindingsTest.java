package org.sami.dreamm.issues;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Project;
import org.sami.spn.statespace.DeepCheck;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** What live checks and deep checks tell of a document, with threads that the test lets go on. */
class LiveFindingsTest {
    /** A thread that does nothing until it is told to. */
    private static final class Queue extends ArrayDeque<Runnable> {
        void runOne() {
            remove().run();
        }

        void runAll() {
            while (!isEmpty()) {
                runOne();
            }
        }
    }

    private final Queue worker = new Queue();
    private final ProjectDocument document = new ProjectDocument(TestVocabulary.TEST, project(), Optional.empty());
    private final EditorState editor = new EditorState(document);
    private final LiveFindings live = new LiveFindings(document, worker::add, Runnable::run, System::nanoTime);
    private final DeepSearch deep = new DeepSearch(worker::add, Runnable::run);
    private final IssueList issues = new IssueList(document, editor, finding -> true, live, deep);

    private static Project project() {
        return NetBuilder.project(
                new NetBuilder("good")
                        .start("start")
                        .end("end")
                        .in("start", "go", "any >= 1")
                        .out("go", "end", "take all any")
                        .build(),
                new NetBuilder("bad")
                        .start("start")
                        .output("start", "Do")
                        .end("end")
                        .places("island")
                        .in("start", "go", "any >= 1")
                        .out("go", "end", "take all any")
                        .build());
    }

    private void add(String place) {
        assertThat(document.apply(new VertexEdit.AddPlace(
                        "good",
                        new Place(place, "", false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()),
                        Optional.of(new LayoutPoint(1, 1)))))
                .isInstanceOf(EditResult.Done.class);
    }

    private List<String> codes() {
        return issues.shown().stream().map(issue -> issue.finding().code()).toList();
    }

    @Test
    void findingsComeBesideTheEventThreadAndAreThoseOfAllChecks() {
        assertThat(live.findings()).as("before the worker had its turn").isEmpty();
        assertThat(live.isChecking()).isTrue();

        worker.runAll();

        assertThat(live.findings()).isEqualTo(PlanChecks.check(document.project(), TestVocabulary.TEST));
        assertThat(codes()).containsExactlyInAnyOrder("W-UNREACHABLE", "W-UNANSWERED");
    }

    @Test
    void ofManyChangesDuringACheckOnlyTheNewestIsCheckedNext() {
        worker.runAll();
        for (int i = 0; i < 20; i++) {
            add("island" + i);
        }

        assertThat(worker).hasSize(1);
        worker.runOne();
        assertThat(live.isChecking()).as("the first of them was checked").isTrue();
        worker.runOne();

        assertThat(live.isChecking()).isFalse();
        assertThat(worker).isEmpty();
        assertThat(live.findings()).isEqualTo(PlanChecks.check(document.project(), TestVocabulary.TEST));
        assertThat(live.tookNs()).isPositive();
    }

    @Test
    void undoneEditTakesItsFindingsAway() {
        worker.runAll();
        add("nowhere");
        worker.runAll();
        assertThat(issues.counts().warnings()).isEqualTo(3);

        document.undo();
        worker.runAll();

        assertThat(issues.counts()).isEqualTo(new IssueCounts(0, 2, 0));
        assertThat(issues.counts().words()).isEqualTo("2 warnings");
    }

    @Test
    void lookingAtAnIssueOpensItsPlanAndHighlightsWhatItIsAbout() {
        worker.runAll();
        assertThat(editor.planId()).contains("good");

        issues.step(true);

        Finding first = issues.current().orElseThrow().finding();
        assertThat(editor.planId()).contains("bad");
        assertThat(editor.highlight()).isNotEmpty().containsAll(first.elements());
        issues.step(true);
        assertThat(issues.current().orElseThrow().finding()).isNotEqualTo(first);
        issues.step(true);
        assertThat(issues.current().orElseThrow().finding())
                .as("behind the last is the first")
                .isEqualTo(first);
        issues.step(false);
        assertThat(issues.current().orElseThrow().finding()).isNotEqualTo(first);
    }

    @Test
    void eventOfAFindingIsShownByItsVertex() {
        assertThat(IssueList.drawn(document.plan("bad").orElseThrow(), List.of("start.Do")))
                .contains("start", "start.Do");
    }

    @Test
    void filterShowsBySeverityPlanAndWord() {
        worker.runAll();
        issues.setFilter(issues.filter().with(Severity.WARNING, false));
        assertThat(issues.shown()).isEmpty();
        issues.setFilter(IssueFilter.ALL.containing("ISLAND"));
        assertThat(codes()).containsExactly("W-UNREACHABLE");
        issues.setFilter(IssueFilter.ALL);
        issues.setOnlyOpenPlan(true);
        assertThat(issues.shown()).as("of the good plan").isEmpty();
        editor.open("bad");
        assertThat(issues.shown()).hasSize(2);
        assertThat(issues.counts().warnings()).as("counters tell of all").isEqualTo(2);
    }

    @Test
    void fixOfAnIssueTakesItAway() {
        worker.runAll();
        document.apply(new EdgeEdit.SetInRequirements(
                "bad", document.plan("bad").orElseThrow().inEdges().get(0).id(), List.of()));
        worker.runAll();
        issues.lookAt(issues.all().stream()
                .filter(issue -> !issue.fixes().isEmpty())
                .findFirst()
                .orElseThrow());
        String code = issues.current().orElseThrow().finding().code();

        document.apply(issues.firstFix().orElseThrow().edit());
        worker.runAll();

        assertThat(codes()).doesNotContain(code);
        assertThat(issues.current()).isEmpty();
    }

    @Test
    void deepFindingsStandAmongTheIssuesUntilTheNetChanges() {
        worker.runAll();
        add("trap");
        worker.runAll();
        DeepCheck reached = DeepChecks.ALL.stream()
                .filter(check -> check.id().equals("never-reached"))
                .findFirst()
                .orElseThrow();
        deep.start(reached, new DeepRequest(document.project(), TestVocabulary.TEST, "good", List.of("A"), 100));
        assertThat(deep.isRunning()).isTrue();
        assertThat(deep.status()).contains("states looked at");

        worker.runAll();

        assertThat(codes()).contains("W-NEVER-REACHED");
        assertThat(deep.status()).startsWith("All ").contains("places");
        document.apply(new VertexEdit.MoveVertices("good", Map.of("trap", new LayoutPoint(5, 5))));
        worker.runAll();
        assertThat(codes()).as("a moved vertex changes no run").contains("W-NEVER-REACHED");
        add("another");
        assertThat(codes()).doesNotContain("W-NEVER-REACHED");
    }

    @Test
    void searchThatIsStoppedSaysHowFarItCame() {
        worker.runAll();
        deep.start(
                DeepChecks.ALL.get(0),
                new DeepRequest(document.project(), TestVocabulary.TEST, "good", List.of("A"), 100));
        deep.cancel();
        worker.runAll();

        assertThat(deep.isRunning()).isFalse();
        assertThat(deep.outcome().orElseThrow().result().states()).isZero();
    }

    private void search(DeepCheck check) {
        deep.start(check, new DeepRequest(document.project(), TestVocabulary.TEST, "good", List.of("A"), 100));
    }

    @Test
    void whatASearchFoundStaysWhileItsPlanRunsTheSame() {
        worker.runAll();
        search(DeepChecks.ALL.get(0));
        worker.runAll();
        DeepSearch.Outcome found = deep.outcome().orElseThrow();

        document.apply(new VertexEdit.MoveVertices("good", Map.of("start", new LayoutPoint(40, 40))));
        assertThat(deep.outcome()).contains(found);
        document.apply(new VertexEdit.NameVertex("bad", "island", "another plan"));
        assertThat(deep.outcome()).as("another plan").contains(found);

        document.apply(new RemoveElements("good", Set.of("go")));
        assertThat(deep.outcome()).as("without its edges").isEmpty();
        document.undo();
        assertThat(deep.outcome()).as("undone").contains(found);
    }

    @Test
    void aSearchOfTheSamePlanIsNotMadeTwiceUnlessItWasStopped() {
        worker.runAll();
        search(DeepChecks.ALL.get(0));
        deep.cancel();
        worker.runAll();
        search(DeepChecks.ALL.get(0));
        assertThat(deep.isRunning()).as("the first was stopped").isTrue();
        worker.runAll();
        DeepSearch.Outcome found = deep.outcome().orElseThrow();

        search(DeepChecks.ALL.get(0));
        assertThat(deep.isRunning()).isFalse();
        assertThat(deep.outcome()).contains(found);
        search(DeepChecks.ALL.get(1));
        assertThat(deep.isRunning()).as("another check").isTrue();
    }
}
