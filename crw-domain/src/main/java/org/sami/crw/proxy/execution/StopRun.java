package org.sami.crw.proxy.execution;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.StopMotors;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.queue.QueuedCommand;

/** Stops the boat for a {@link Stop} command: one request, one answer. */
final class StopRun extends CommandRun {
    private final String wireId;
    private final PendingRequests requests;

    StopRun(QueuedCommand queued, String wireId, PendingRequests requests) {
        super(queued);
        this.wireId = wireId;
        this.requests = requests;
    }

    @Override
    public String state() {
        return "being stopped";
    }

    @Override
    public boolean isDriving() {
        return false;
    }

    @Override
    void begin(long nowMs) {
        requests.send(new StopMotors(wireId + "/stop"), nowMs);
    }

    @Override
    Verdict answered(CommandMessage asked, LinkMessage answer, long nowMs) {
        return Verdict.COMPLETED;
    }

    @Override
    boolean isAbout(Progress progress) {
        return false;
    }

    @Override
    Verdict resume(Progress held, long nowMs) {
        return because(Verdict.RETRY, "the link was lost");
    }
}
