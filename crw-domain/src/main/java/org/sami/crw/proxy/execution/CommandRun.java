package org.sami.crw.proxy.execution;

import java.util.Optional;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.Progress;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.spn.value.GeoPoint;

/** One try to have the boat carry out a command: what is asked of it, and what its answers mean for the command. */
public abstract class CommandRun {

    /** What becomes of the try after an answer. */
    enum Verdict {
        /** It goes on. */
        GO_ON,
        /** The command is done. */
        COMPLETED,
        /** Another try may do it. */
        RETRY,
        /** The boat will not do it now, for a reason that will pass. */
        WAIT,
        /** The command cannot be done. */
        FAILED
    }

    private final QueuedCommand queued;
    private String why = "";

    CommandRun(QueuedCommand queued) {
        this.queued = queued;
    }

    /** The command that is tried. */
    public final QueuedCommand queued() {
        return queued;
    }

    /** Why the verdict was not to go on, in words. */
    final String why() {
        return why;
    }

    /** How far the try is, in words. */
    public abstract String state();

    /** How the boat comes along its path, once it is to be under way. */
    public Optional<ProgressMonitor> headway() {
        return Optional.empty();
    }

    /** How many points of the command's path are behind the boat, which has said how far it is. */
    int visited(Progress progress) {
        return progress.nextIndex();
    }

    /** The point to which the boat drives now. */
    public Optional<GeoPoint> target() {
        return Optional.empty();
    }

    /** Tells that point from those before and after it. */
    int targetIndex() {
        return 0;
    }

    /** What the boat drives along, where it is under way. */
    Optional<Underway> underway(long nowMs) {
        return Optional.empty();
    }

    /** Whether the boat is expected to be under way. */
    public abstract boolean isDriving();

    /** Asks the first thing of the boat. */
    abstract void begin(long nowMs);

    /** The boat has done what was asked. */
    abstract Verdict answered(CommandMessage asked, LinkMessage answer, long nowMs);

    /** Whether a report of progress tells of this command: it names the list of this try, which has been started. */
    abstract boolean isAbout(Progress progress);

    /** The boat has come to the end of its list. */
    Verdict arrived() {
        return Verdict.COMPLETED;
    }

    /** The boat has said where it is. */
    Verdict at(GeoPoint position, long nowMs) {
        return Verdict.GO_ON;
    }

    /** The link is back after a break, and the boat has said what it holds. */
    abstract Verdict resume(Progress held, long nowMs);

    /** The boat has refused what was asked. */
    final Verdict refused(Nack nack) {
        return switch (nack.reason()) {
            case NOT_GREETED, NOT_COMMANDER, FLEET_STOPPED -> because(Verdict.WAIT, nack.detail());
            case UNKNOWN_LIST, STALE, ID_TAKEN -> // another try has an id of its own
                because(Verdict.RETRY, nack.detail());
            case NOT_ABLE -> because(Verdict.FAILED, nack.detail());
            default -> because(Verdict.FAILED, "the boat refused it: " + nack.reason() + ", " + nack.detail());
        };
    }

    final Verdict because(Verdict verdict, String reason) {
        why = reason;
        return verdict;
    }
}
