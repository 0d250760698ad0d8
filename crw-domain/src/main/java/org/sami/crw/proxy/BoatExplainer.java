package org.sami.crw.proxy;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.execution.CommandDriver;
import org.sami.crw.proxy.execution.CommandRun;
import org.sami.crw.proxy.execution.ProgressMonitor;
import org.sami.crw.proxy.execution.StationRun;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.explanation.ExplainedCommand;
import org.sami.crw.proxy.explanation.LastCommandOutcome;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.explanation.Obstacle;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.Drift;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Ids;

/** Answers "why is this boat not moving?" from its condition and the queue of its commands. */
final class BoatExplainer {
    private static final int MOST_NAMED = 3;

    /** What a boat does that drives without leaving its place; which of the two, it does not say. */
    private static final String MAKES_ROOM = "makes room for another boat or drives back";

    private static final String NOT_LOCATED = "it has not said where it is, so its way cannot be checked";

    /** Slower than this it may as well drift, in m/s: more than a current and a breeze in the field. */
    private static final double DRIVES_MPS = 0.4;

    /** A boat that is faster is never said not to move, in m/s. */
    private static final double RESTS_MPS = 0.3;

    private static final long SILENT_S = 10; // boats report where they are each second or more often

    /** Reported heights up to this, in m, are taken for the ground. */
    private static final double GROUND_M = 0.5;

    private final String boatId;
    private final CommandDriver driver;
    private final BoatCondition condition;
    private final ProxySettings settings;
    private final MissionTitles titles;

    BoatExplainer(
            String boatId,
            CommandDriver driver,
            BoatCondition condition,
            ProxySettings settings,
            MissionTitles titles) {
        this.boatId = boatId;
        this.driver = driver;
        this.condition = condition;
        this.settings = settings;
        this.titles = titles;
    }

    BoatExplanation explain() {
        Optional<Obstacle> obstacle = condition.obstacle();
        if (obstacle.filter(one -> one.cause() == Cause.LINK_LOST).isPresent()) {
            return outOfReach(obstacle.get());
        } else if (obstacle.filter(one -> one.cause() == Cause.TAKEN_OVER).isPresent()) {
            boolean says = condition.status.mode().equals(Optional.of(BoatMode.TELEOPERATION));
            return new BoatExplanation(
                    false,
                    Cause.TAKEN_OVER,
                    boatId
                            + (says
                                    ? " is driven by hand"
                                    : " is kept for a person, and does not say that it is driven by hand")
                            + counted());
        } else if (obstacle.isPresent()) {
            return still(obstacle.get().cause(), obstacle.get().text() + counted());
        } else if (condition.unfit().isPresent() && driver.queue().size() == 0) {
            return new BoatExplanation(
                    false, Cause.OTHER_KIND, boatId + " " + condition.unfit().get());
        } else if (isBatteryEmpty()) {
            return still(Cause.BATTERY_EMPTY, "its battery is empty" + wanted());
        } else if (driver.isHolding()) {
            return holding(driver.run().get());
        } else if (driver.run().isPresent()) {
            return running(driver.run().get());
        } else if (driver.waitsForPosition()) {
            return still(Cause.NO_POSITION, NOT_LOCATED + counted());
        } else if (driver.isStopping()) {
            return still(Cause.STOPPING, "no mission wants anything of it; it is being stopped");
        } else if (driver.queue().blockedBy().isPresent()) {
            long blocker = driver.queue().blockedBy().get();
            return inItsPlace(Cause.BLOCKED, titles.words(blocker) + " keeps it where it is" + counted());
        }
        Cause last = driver.lastWord().cause();
        String nobody = (isAirborne() ? "no mission has a command for it now" : "no mission wants anything of it")
                + became().map(text -> "; " + text).orElse("");
        return isReturning()
                ? new BoatExplanation(false, last, boatId + " returns to its home, as its link was lost: " + nobody)
                : inItsPlace(last, nobody);
    }

    /** A boat that keeps its place drives aside for another one, and back, by itself (docs/services.md): then it is not said to stand. */
    private BoatExplanation inItsPlace(Cause cause, String why) {
        return drivesInItsPlace()
                ? new BoatExplanation(false, cause, boatId + " keeps its place, and " + MAKES_ROOM + ": " + why)
                : still(cause, why);
    }

    private boolean drivesInItsPlace() {
        BoatStatus status = condition.status;
        return status.mode().filter(BoatMode.HOLD::equals).isPresent()
                && status.pose().filter(pose -> pose.speedMps() >= DRIVES_MPS).isPresent();
    }

    /** Whether the boat says that it is on its way home by itself. */
    private boolean isReturning() {
        return condition.status.mode().filter(BoatMode.RETURN::equals).isPresent();
    }

    /** The boat cannot be seen; it does what it is configured to do by itself. */
    private BoatExplanation outOfReach(Obstacle lost) {
        String byItself = settings.inForce()
                .map(BoatTuning::lostLinkAction)
                .map(action -> "; by itself it " + LostLinkWords.of(action))
                .orElse("");
        return new BoatExplanation(
                false, lost.cause(), boatId + " is out of reach: " + lost.text() + byItself + counted());
    }

    /** Whether the boat is under way as it should be, so that there is nothing to explain. */
    boolean isUnderWay() {
        return driver.isDriving()
                && condition.obstacle().isEmpty()
                && !isBatteryEmpty()
                && driver.run()
                        .flatMap(CommandRun::headway)
                        .filter(ProgressMonitor::isShown)
                        .isEmpty();
    }

    private boolean isBatteryEmpty() {
        return condition
                .status
                .battery()
                .filter(battery -> battery.percent() <= 0)
                .isPresent();
    }

    private String wanted() {
        return driver.run()
                .map(run -> "; it should " + explained(run.queued()).infinitive())
                .orElse("");
    }

    private BoatExplanation running(CommandRun run) {
        ExplainedCommand command = explained(run.queued());
        String visited = visited(run.queued());
        Optional<ProgressMonitor> stuck = run.headway().filter(ProgressMonitor::isShown);
        if (stuck.isPresent()) {
            return new BoatExplanation(
                    false,
                    Cause.NO_PROGRESS,
                    boatId + " does not get on: " + stuck.get().words() + "; it is to " + command.infinitive() + visited
                            + givesWay(Cause.UNDER_WAY) + waiting());
        }
        Cause cause = run.isDriving() ? Cause.UNDER_WAY : causeOf(run);
        String state = ": " + run.state() + visited;
        if (cause == Cause.KEEPS_STATION) {
            state = drivesInItsPlace() ? ", and " + MAKES_ROOM : "";
        }
        String does = switch (cause) {
            case KEEPS_STATION, TAKES_PICTURES -> command.does();
            case UNDER_WAY -> run instanceof StationRun ? "is to " + command.infinitive() : command.does();
            default -> "waits to " + command.infinitive();
        };
        return new BoatExplanation(
                run.isDriving(), cause, boatId + " " + does + state + givesWay(cause) + sends() + waiting());
    }

    private String givesWay(Cause cause) {
        return cause == Cause.UNDER_WAY
                ? condition.givesWayTo.map(other -> ", gives way to " + other).orElse("")
                : "";
    }

    /** Nobody wants anything of it; what it last did says why it holds its place. */
    private BoatExplanation holding(CommandRun run) {
        String became = became().map(text -> ": " + text).orElse("");
        return new BoatExplanation(
                run.isDriving(),
                run.isDriving() ? Cause.UNDER_WAY : causeOf(run),
                boatId + " holds its place until it gets a command or is stopped" + became);
    }

    /** What became of its last command. A path of a robot that flies may have led to the ground on which it stood. */
    private Optional<String> became() {
        LastCommandOutcome last = driver.lastWord();
        Optional<BoatCommand> landed = last.command()
                .filter(command ->
                        condition.flies && !isAirborne() && last.cause() == Cause.ARRIVED && endsOnGround(command));
        return landed.isEmpty()
                ? last.text(titles)
                : Optional.of("it is on the ground, where its path ended for "
                        + titles.words(landed.get().mission()));
    }

    private static boolean endsOnGround(BoatCommand command) {
        return command.mission() != Ids.NONE
                && command instanceof FollowPath path
                && path.points().get(path.points().size() - 1).altM() == 0;
    }

    private static Cause causeOf(CommandRun run) {
        if (run.queued().command() instanceof Stop) {
            return Cause.STOPPING;
        }
        if (run.queued().command() instanceof Panorama) {
            return Cause.TAKES_PICTURES;
        }
        return run instanceof StationRun station && station.isThere() ? Cause.KEEPS_STATION : Cause.UPLOADING;
    }

    private ExplainedCommand explained(QueuedCommand queued) {
        return ExplainedCommand.of(queued.command(), titles);
    }

    private static String visited(QueuedCommand queued) {
        return queued.command() instanceof FollowPath path && path.mission() != Ids.NONE
                ? ", " + queued.visited() + " of " + path.points().size() + " points visited"
                : "";
    }

    private String sends() {
        int sends = driver.sends();
        return sends > 1 ? ", sent " + sends + " times without an answer" : "";
    }

    /** Who waits for what runs, and why it does not run itself. */
    private String waiting() {
        List<QueuedCommand> waiting = driver.queue().waiting();
        StringBuilder text = new StringBuilder();
        for (QueuedCommand queued : waiting.subList(0, Math.min(MOST_NAMED, waiting.size()))) {
            text.append("; ")
                    .append(explained(queued).doing())
                    .append(" waits: ")
                    .append(driver.queue().whyNot(queued).words(titles));
        }
        if (waiting.size() > MOST_NAMED) {
            text.append("; ").append(waiting.size() - MOST_NAMED).append(" more wait");
        }
        return text.toString();
    }

    private String counted() {
        int commands = driver.queue().size();
        if (commands == 0) {
            return "";
        }
        return commands == 1 ? "; one command waits" : "; " + commands + " commands wait";
    }

    private String moves() {
        return silentS()
                .map(seconds -> "has not said for " + seconds + " s where it is")
                .orElseGet(this::movesByItsWords);
    }

    /** For how long a boat that is linked has said nothing of where it is, as one without a position; empty for a few seconds. */
    private Optional<Long> silentS() {
        return condition
                .sighting
                .map(seen -> (condition.nowMs - seen.atMs()) / 1000)
                .filter(seconds -> seconds >= SILENT_S && condition.status.link() == LinkState.LINKED);
    }

    private String movesByItsWords() {
        return condition
                .status
                .pose()
                .map(BoatPose::speedMps)
                .filter(mps -> condition.status.link() == LinkState.LINKED && mps > RESTS_MPS)
                .map(mps -> String.format(Locale.ROOT, "moves at %.1f m/s", mps))
                .orElseGet(() ->
                        isAirborne() ? String.format(Locale.ROOT, "hovers %.0f m high", altM()) : "does not move");
    }

    private boolean isAirborne() {
        return condition.flies && altM() > GROUND_M;
    }

    private double altM() {
        return condition.status.pose().map(pose -> pose.position().altM()).orElse(0.0);
    }

    private BoatExplanation still(Cause cause, String why) {
        String does =
                condition.drift().filter(Drift::isMoving).map(Drift::words).orElseGet(this::moves);
        return new BoatExplanation(false, cause, boatId + " " + does + ": " + why);
    }
}
