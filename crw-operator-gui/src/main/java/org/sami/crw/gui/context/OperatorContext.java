package org.sami.crw.gui.context;

import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.LaunchFacts;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.session.Session;
import org.sami.palette.ProxyMarks;
import org.sami.session.api.FrontSession;
import org.sami.session.api.RefusedException;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.window.Notices;

/**
 * What all panels of a window work on. On the event thread, which the session's results and the models' listeners arrive on as well.
 *
 * @param shown the session that runs, or the replay of one
 * @param marks of the boats, the same in all panels
 * @param boats which are selected
 * @param notices the notices in the strip at the top
 */
public record OperatorContext(
        ShownSession shown, CommandRegistry commands, ProxyMarks marks, BoatSelection boats, Notices notices) {
    /** The name under which the window's operator answers and commands. */
    public static final String OPERATOR = "operator";

    private static final String REPLAY = "this is a replay";
    private static final String ELSEWHERE = "the session runs in another process: this is done there";

    public OperatorContext {
        Objects.requireNonNull(shown, "shown");
        Objects.requireNonNull(commands, "commands");
        Objects.requireNonNull(marks, "marks");
        Objects.requireNonNull(boats, "boats");
        Objects.requireNonNull(notices, "notices");
    }

    /** The context of a window over a session that runs. */
    public OperatorContext(
            FrontSession session, CommandRegistry commands, ProxyMarks marks, BoatSelection boats, Notices notices) {
        this(new RunningSession(session), commands, marks, boats, notices);
    }

    /**
     * The session that runs, for what acts on it.
     *
     * @throws IllegalStateException in a replay, where nothing that acts can be run ({@link #whyNotAct})
     */
    public FrontSession session() {
        return shown.session().orElseThrow(() -> new IllegalStateException(REPLAY));
    }

    /**
     * The session itself, for what only its own machine has: files, keys.
     *
     * @throws IllegalStateException where it runs elsewhere ({@link #whyNotHere})
     */
    public Session here() {
        return Session.inProcess(session()).orElseThrow(() -> new IllegalStateException(ELSEWHERE));
    }

    /** Why what only the session's own machine has cannot be used; empty where it can. */
    public Optional<String> whyNotHere() {
        return whyNotAct()
                .or(() -> shown.session().flatMap(Session::inProcess).isPresent()
                        ? Optional.empty()
                        : Optional.of(ELSEWHERE));
    }

    /** Why nothing can act on boats or missions; empty where it can. */
    public Optional<String> whyNotAct() {
        return shown.session().isPresent() ? Optional.empty() : Optional.of(REPLAY);
    }

    /** What the session that runs wishes that boats do when their link is lost; empty where it wishes nothing, and in a replay. */
    public Optional<LostLinkAction> lostLinkWish() {
        return shown.session().flatMap(session -> session.fleet().lostLinkWish());
    }

    /** What counts for the checks of boats besides the boats themselves. */
    public LaunchFacts launchFacts() {
        return new LaunchFacts(
                robots(), models().alarms().snapshot(), models().messages().messages(), lostLinkWish(), nowMillis());
    }

    /** Whether a robot is known to fly, or is to before its first report. */
    public boolean flies(String robot) {
        return models().fleet().boat(robot).map(boat -> boat.kind(robots())).orElse(robots()) == RobotKind.COPTER;
    }

    /** What the session's plans command: what they are called. */
    public RobotKind robots() {
        return HandlerModules.robotsOf(vocabulary());
    }

    /** A text about boats, with the word for the session's robots. */
    public String say(String text) {
        return robots().say(text);
    }

    /** What one robot is; where both kinds are together, one that has not reported yet is taken for a boat. */
    public RobotKind kindOf(String robot) {
        return robots().of(models().fleet().boat(robot).map(BoatSnapshot::flies).orElse(false));
    }

    /** A text about one boat, with the word for what that robot is. */
    public String sayOf(String robot, String text) {
        return kindOf(robot).say(text);
    }

    /** The session's models. */
    public OperatorModels models() {
        return shown.models();
    }

    /** Names missions by their numbers and plans. */
    public MissionTitles titles() {
        return models().missions()::title;
    }

    /** The words of the session. */
    public Vocabulary vocabulary() {
        return shown.vocabulary();
    }

    /** The session's time in ms. */
    public long nowMillis() {
        return shown.nowMillis();
    }

    /** Tells what came of something that was asked of the session: that it was done, or why not. */
    public <T> void tell(CompletionStage<T> stage, String done) {
        stage.whenComplete((result, fault) -> {
            if (fault == null) {
                notices.show(done);
            } else {
                notices.refused(RefusedException.reason(fault));
            }
        });
    }
}
