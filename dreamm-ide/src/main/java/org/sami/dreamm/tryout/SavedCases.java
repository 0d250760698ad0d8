package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.engine.MissionView;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.testcase.CaseCoverage;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The saved test cases of the open plan: the result of each case's last run, and the parts of the plan that they visit. They run off the
 * event thread; a plan that changes makes what was known of them old. On the document's thread.
 */
public final class SavedCases {
    private final ProjectDocument document;
    private final EditorState editor;
    private final Executor worker;
    private final Executor owner;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private Optional<Ran> ran = Optional.empty();
    private boolean running;
    private String message = "";

    /** What came of running the cases of one version of a plan. */
    private record Ran(String plan, Map<TestCase, Optional<String>> results, CaseCoverage coverage) {}

    /** The cases of whichever plan is open. */
    public SavedCases(ProjectDocument document, EditorState editor, Executor worker, Executor owner) {
        this.document = Objects.requireNonNull(document, "document");
        this.editor = Objects.requireNonNull(editor, "editor");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        document.addListener((DocumentChange change) -> {
            if (NetChanges.in(change)) {
                ran = Optional.empty();
                message = "";
            }
            tell();
        });
        editor.addListener(new EditorListener() {
            @Override
            public void planOpened() {
                message = "";
                tell();
            }
        });
    }

    /** The cases in the order of the plan, with what is known of each. */
    List<CaseResult> cases() {
        List<CaseResult> cases = new ArrayList<>();
        for (TestCase test : editor.plan().map(Plan::testCases).orElse(List.of())) {
            Optional<Optional<String>> result =
                    ofOpenPlan().map(Ran::results).flatMap(r -> Optional.ofNullable(r.get(test)));
            cases.add(new CaseResult(test, result.isPresent(), result.flatMap(failure -> failure)));
        }
        return cases;
    }

    private Optional<Ran> ofOpenPlan() {
        return ran.filter(r -> editor.planId().equals(Optional.of(r.plan())));
    }

    /** What the cases of the open plan visit; empty where they were not run on it as it is now. */
    public Optional<CaseCoverage> coverage() {
        return ofOpenPlan().map(Ran::coverage);
    }

    /** Whether they are run just now. */
    public boolean isRunning() {
        return running;
    }

    /** What came of them, in one sentence; empty text where nothing did. */
    public String message() {
        return message;
    }

    /** Why they cannot be run now; empty where they can. */
    public Optional<String> whyNotRun() {
        if (running) {
            return Optional.of("they run already");
        }
        return editor.plan().map(Plan::testCases).orElse(List.of()).isEmpty()
                ? Optional.of("the open plan has no saved test case")
                : Optional.empty();
    }

    /** Runs all cases of the open plan. */
    public void runAll() {
        Optional<Plan> open = editor.plan();
        if (whyNotRun().isPresent() || open.isEmpty()) {
            return;
        }
        Project project = document.project();
        running = true;
        message = "Running…";
        tell();
        worker.execute(() -> {
            Ran result = run(project, document.vocabulary(), open.get());
            owner.execute(() -> finished(project, result));
        });
    }

    private static Ran run(Project project, Vocabulary vocabulary, Plan plan) {
        Map<TestCase, Optional<String>> results = new LinkedHashMap<>();
        Optional<String> error = PlanChecks.check(project, vocabulary, plan.id()).stream()
                .filter(Finding::isError)
                .map(Finding::message)
                .findFirst();
        if (error.isPresent()) {
            plan.testCases()
                    .forEach(test -> results.put(test, error.map(why -> "a plan with an error is not run: " + why)));
            return new Ran(plan.id(), results, CaseCoverage.of(plan, List.of()));
        }
        TestCaseRunner runner = new TestCaseRunner(project, vocabulary);
        List<TestCaseRunner.Trace> traces = new ArrayList<>();
        for (TestCase test : plan.testCases()) {
            TestCaseRunner.Trace trace = runner.trace(plan, test);
            traces.add(trace);
            results.put(test, trace.failure().map(Finding::message));
        }
        return new Ran(plan.id(), results, CaseCoverage.of(plan, traces));
    }

    @SuppressWarnings("ReferenceEquality") // edits make other objects: the same one is the same version
    private void finished(Project project, Ran result) {
        running = false;
        Optional<Plan> now = document.plan(result.plan());
        boolean same = project == document.project()
                || (now.equals(project.plan(result.plan()))
                        && project.plans().equals(document.project().plans()));
        if (same) {
            ran = Optional.of(result);
            long failed = result.results().values().stream()
                    .filter(Optional::isPresent)
                    .count();
            message = result.results().size() - failed + " passed, " + failed + " failed; "
                    + result.coverage().words();
        } else {
            message = "The plan has changed while its cases ran: run them again";
        }
        tell();
    }

    /**
     * The edit that keeps a run as a case of its plan, with what stands where at its end as what is expected.
     *
     * @throws IllegalStateException if a test case cannot express its steps ({@link Stepper#whyNotATestCase})
     */
    static Edit keeping(String plan, Stepper tried, String name) {
        Stepper end = tried.fork();
        if (end.outcome().filter(Outcome.ENDED::equals).isPresent()) {
            end.expectEnded();
        } else {
            end.view()
                    .mission(end.mission())
                    .map(MissionView::marking)
                    .ifPresent(marking -> List.copyOf(marking.keySet()).forEach(end::expectTokens));
        }
        return new ProjectEdit.SetTestCase(plan, name, Optional.of(end.testCase(name)));
    }

    /** One line about a case: its starting tokens and the number of its steps. */
    static String words(TestCase test) {
        long expected = test.steps().stream()
                .filter(step -> step instanceof TestStep.ExpectTokens || step instanceof TestStep.ExpectEnded)
                .count();
        return test.proxies().size() + " robots, " + (test.steps().size() - expected) + " steps, " + expected
                + " expectations" + (test.start().isPresent() ? ", from a marking" : "");
    }

    /** Tells somebody when something has changed. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }
}
