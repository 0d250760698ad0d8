package org.sami.dreamm.issues;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.KeyStroke;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.model.TestCase;
import org.sami.spn.statespace.DeepCheck;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepRequest;
import org.sami.ui.command.Command;

/** What can be done with issues: go through them, show, mend, play, and search deeper. */
public final class IssueCommands {

    /** The key that shows a row, while the list has the focus. */
    static final KeyStroke SHOW = KeyStroke.getKeyStroke("ENTER");

    private static final List<String> DEEP_KEYS =
            List.of("ctrl F8", "ctrl shift F8", "alt F8", "alt shift F8", "ctrl alt F8", "ctrl alt shift F8", "alt F2");

    private final DreammContext context;
    private final IssueList issues;
    private final DeepSearch deep;
    private final List<Command> deepCommands = new ArrayList<>();
    private final Command stop;

    /**
     * Adds the commands to a window's.
     *
     * @param robots names of the robots with which deep checks run a plan
     * @param player plays a run of the open plan
     */
    public IssueCommands(
            DreammContext context,
            IssueList issues,
            DeepSearch deep,
            Supplier<List<String>> robots,
            Consumer<TestCase> player) {
        this.context = context;
        this.issues = issues;
        this.deep = deep;
        add("issue-next", "Next issue", "F8", "down", () -> issues.step(true), this::whyNone);
        add("issue-previous", "Previous issue", "shift F8", "up", () -> issues.step(false), this::whyNone);
        add("issue-show", "Show the issue on the net", "", "fit", this::show, this::whyNotChosen)
                .withFocusKeys(List.of(SHOW));
        add("issue-fix", "Mend the issue", "alt ENTER", "check", this::fix, this::whyNoFix);
        add(
                "issue-play",
                "Play the run that leads there",
                "alt shift ENTER",
                "play",
                () -> issues.current().flatMap(Issue::witness).ifPresent(player),
                this::whyNoWitness);
        Iterator<String> keys = DEEP_KEYS.iterator();
        for (DeepCheck check : DeepChecks.ALL) {
            deepCommands.add(add(
                    "deep-" + check.id(),
                    check.title(),
                    keys.hasNext() ? keys.next() : "",
                    "search",
                    () -> run(check, robots.get()),
                    this::whyNotDeep));
        }
        stop = add(
                "deep-stop",
                "Stop the search",
                "ctrl F2",
                "stop",
                deep::cancel,
                () -> deep.isRunning() ? Optional.empty() : Optional.of("no search runs"));
    }

    private Command add(
            String id, String title, String key, String icon, Runnable run, Supplier<Optional<String>> whyNot) {
        Command command = new Command(id, title, run).withIcon(icon).unless(whyNot);
        return context.commands().add(key.isEmpty() ? command : command.withKey(key));
    }

    private Optional<String> whyNone() {
        return issues.shown().isEmpty() ? Optional.of("no issue is shown") : Optional.empty();
    }

    private Optional<String> whyNotChosen() {
        return issues.current().isPresent() ? Optional.empty() : Optional.of("no issue is chosen (F8 chooses one)");
    }

    private Optional<String> whyNoFix() {
        return issues.current().isPresent() && issues.firstFix().isEmpty()
                ? Optional.of("this issue has no mechanical fix: mend it by hand")
                : whyNotChosen();
    }

    private Optional<String> whyNoWitness() {
        return issues.current().isPresent()
                        && issues.current().flatMap(Issue::witness).isEmpty()
                ? Optional.of("no run leads to this issue: it shows in the drawing alone")
                : whyNotChosen();
    }

    private Optional<String> whyNotDeep() {
        if (deep.isRunning()) {
            return Optional.of("a search runs already");
        }
        Optional<String> plan = context.editor().planId();
        if (plan.isEmpty()) {
            return Optional.of("no plan is open");
        }
        boolean errors = issues.all().stream().anyMatch(issue -> issue.finding().isError());
        return errors
                ? Optional.of("there are errors: mend those first, plans with errors are not run")
                : Optional.empty();
    }

    private void show() {
        issues.current().ifPresent(issues::lookAt);
    }

    private void fix() {
        issues.firstFix().ifPresent(fix -> context.apply(fix.edit()));
    }

    private void run(DeepCheck check, List<String> robots) {
        context.editor()
                .planId()
                .ifPresent(plan -> deep.start(
                        check,
                        new DeepRequest(
                                context.document().project(),
                                context.vocabulary(),
                                plan,
                                robots,
                                DeepRequest.STANDARD_STATES)));
    }

    DeepSearch deep() {
        return deep;
    }

    List<Command> deepCommands() {
        return deepCommands;
    }

    Command stop() {
        return stop;
    }
}
