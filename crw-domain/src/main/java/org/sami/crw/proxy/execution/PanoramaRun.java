package org.sami.crw.proxy.execution;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.Progress;
import org.sami.boat.link.TakePanorama;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.spn.value.GeoPoint;

/** Has the boat take pictures all round. A report that is lost with its link cannot be asked for again: they are taken again. */
final class PanoramaRun extends CommandRun {
    /** A boat that has not reported after so long was kept from it, or its report was lost. */
    static final long LONGEST_MS = CommandDefaults.LONGEST_PANORAMA_MS;

    private final Panorama panorama;
    private final String wireId;
    private final PendingRequests requests;
    private long sinceMs;
    private boolean turning;

    PanoramaRun(QueuedCommand queued, Panorama panorama, String wireId, PendingRequests requests) {
        super(queued);
        this.panorama = panorama;
        this.wireId = wireId;
        this.requests = requests;
    }

    @Override
    public String state() {
        return turning ? "turning all round" : "being told to take pictures";
    }

    @Override
    public boolean isDriving() {
        return false; // it keeps a station
    }

    @Override
    void begin(long nowMs) {
        sinceMs = nowMs;
        requests.send(new TakePanorama(wireId, panorama.pictures()), nowMs);
    }

    @Override
    Verdict answered(CommandMessage asked, LinkMessage answer, long nowMs) {
        turning = true;
        return Verdict.GO_ON;
    }

    @Override
    boolean isAbout(Progress progress) {
        return false;
    }

    boolean isAbout(PanoramaReport report) {
        return report.commandId().equals(wireId);
    }

    @Override
    Verdict at(GeoPoint position, long nowMs) {
        return nowMs - sinceMs >= LONGEST_MS
                ? because(Verdict.RETRY, "no pictures came within " + LONGEST_MS / 1000 + " s")
                : Verdict.GO_ON;
    }

    @Override
    Verdict resume(Progress held, long nowMs) {
        return because(Verdict.RETRY, "the link was lost");
    }
}
