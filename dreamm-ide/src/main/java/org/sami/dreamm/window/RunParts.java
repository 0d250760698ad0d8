package org.sami.dreamm.window;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javax.swing.JComponent;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.issues.DeepSearch;
import org.sami.dreamm.issues.IssueCommands;
import org.sami.dreamm.issues.IssueCounters;
import org.sami.dreamm.issues.IssueList;
import org.sami.dreamm.issues.IssuesPanel;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.dreamm.query.BoundsOfPlan;
import org.sami.dreamm.query.QueriesView;
import org.sami.dreamm.query.QueryAnswers;
import org.sami.dreamm.query.QueryCommands;
import org.sami.dreamm.query.StatesOfPlan;
import org.sami.dreamm.query.WitnessOnNet;
import org.sami.dreamm.replay.ReplayPanel;
import org.sami.dreamm.suggestion.SuggestionCommands;
import org.sami.dreamm.tryout.NextStepSearch;
import org.sami.dreamm.tryout.SavedCases;
import org.sami.dreamm.tryout.StartMarkingSetup;
import org.sami.dreamm.tryout.TryOut;
import org.sami.dreamm.tryout.TryOutCommands;
import org.sami.dreamm.tryout.TryOutOverlay;
import org.sami.dreamm.tryout.TryOutPanel;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.ui.EventThread;

/** What checks and runs the plan that is written, for the panels of one window: models, commands, and threads of their own. */
final class RunParts implements AutoCloseable {
    private final ExecutorService checking = worker("dreamm-checks");
    private final ExecutorService searching = worker("dreamm-search");
    private final ExecutorService trying = worker("dreamm-try");
    private final ExecutorService replaying = worker("dreamm-replay");
    private final ExecutorService grading = worker("dreamm-grade");
    private final DreammContext context;
    private final LiveFindings live;
    private final IssueList issues;
    private final IssueCommands issueCommands;
    private final TryOut tryOut;
    private final StartMarkingSetup setup = new StartMarkingSetup();
    private final SavedCases cases;
    private final TryOutOverlay overlay;
    private final TryOutCommands tryOutCommands;
    private final QueryAnswers queries;
    private final WitnessOnNet witness;
    private final QueryCommands queryCommands;
    private final StatesOfPlan states;
    private final BoundsOfPlan bounds;

    /**
     * Parts of a window, whose commands are added to its context.
     *
     * @param context of the window
     */
    RunParts(DreammContext context) {
        this.context = context;
        live = new LiveFindings(context.document(), checking, EventThread.executor(), System::nanoTime);
        DeepSearch deep = new DeepSearch(searching, EventThread.executor());
        issues = new IssueList(
                context.document(),
                context.editor(),
                finding -> context.profile().shows(ProfileIds.finding(finding.code())),
                live,
                deep);
        tryOut = new TryOut(context.document());
        cases = new SavedCases(context.document(), context.editor(), searching, EventThread.executor());
        overlay = new TryOutOverlay(context, tryOut, setup, cases);
        tryOutCommands = new TryOutCommands(
                context, tryOut, new NextStepSearch(tryOut, trying, EventThread.executor()), setup, cases, overlay);
        issueCommands = new IssueCommands(context, issues, deep, tryOut::robotNames, run -> {
            context.editor().planId().ifPresent(plan -> tryOut.play(plan, run));
            show("panel-try-out");
        });
        SuggestionCommands.addTo(context, searching, EventThread.executor());
        queries = new QueryAnswers(context.document(), context.editor(), searching, EventThread.executor());
        witness = new WitnessOnNet(context.overlay(), overlay);
        states = new StatesOfPlan(context, witness, tryOut::robotNames, searching, EventThread.executor());
        bounds = new BoundsOfPlan(context, overlay, tryOut::robotNames, searching, EventThread.executor());
        bounds.addListener(() -> issues.showAlso(bounds::notes));
        queryCommands = new QueryCommands(
                context,
                queries,
                witness,
                tryOut::robotNames,
                () -> setup.start().map(TestStart::marking),
                () -> issues.all().stream().anyMatch(issue -> issue.finding().isError()),
                run -> {
                    context.editor().planId().ifPresent(plan -> tryOut.play(plan, run));
                    show("panel-try-out");
                });
    }

    private static ExecutorService worker(String name) {
        return Executors.newSingleThreadExecutor(work -> {
            Thread thread = new Thread(work, name);
            thread.setDaemon(true);
            return thread;
        });
    }

    private void show(String panel) {
        context.commands().find(panel).ifPresent(command -> command.run());
    }

    /** Where plans of jobs are graded. */
    Executor grading() {
        return grading;
    }

    /** Plays a test case of a plan and shows it; false where the plan is not started. */
    boolean play(String plan, TestCase test) {
        tryOut.stop();
        boolean begun = tryOut.play(plan, test) || tryOut.stepper().isPresent();
        if (begun) {
            show("panel-try-out");
        }
        return begun;
    }

    /** The findings about the document, which all panels share. */
    LiveFindings live() {
        return live;
    }

    IssueList issueList() {
        return issues;
    }

    JComponent issues() {
        return new IssuesPanel(context, issues, issueCommands);
    }

    JComponent tryOut() {
        TryOutPanel panel = new TryOutPanel(context, tryOut, tryOutCommands, setup, cases);
        tryOutCommands.whenStarted(() -> {
            if (!panel.isShowing()) {
                Component focused =
                        KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
                show("panel-try-out");
                Optional.ofNullable(focused).ifPresent(Component::requestFocusInWindow);
            }
        });
        return panel;
    }

    JComponent queries() {
        return new QueriesView(context, queries, witness, queryCommands, states, bounds);
    }

    ReplayPanel replay() {
        return new ReplayPanel(context, tryOut, overlay, replaying);
    }

    /** How many issues there are, for a corner of the window. */
    JComponent counters() {
        return new IssueCounters(issues, () -> show("panel-issues"));
    }

    @Override
    public void close() {
        checking.shutdownNow();
        searching.shutdownNow();
        trying.shutdownNow();
        replaying.shutdownNow();
        grading.shutdownNow();
    }
}
