package org.sami.crw.sim.fleet;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.listener.BoatListener;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatStatus;

/** Writes down all that a proxy reports, telemetry apart. */
final class ProxyEventRecorder implements BoatListener {
    final List<String> lines = new ArrayList<>();
    int statuses;

    @Override
    public void onCompleted(String boatId, BoatCommand command) {
        lines.add("completed " + command.commandId());
    }

    @Override
    public void onFailed(String boatId, BoatCommand command, String reason) {
        lines.add("failed " + command.commandId() + ": " + reason);
    }

    @Override
    public void onWithdrawn(String boatId, BoatCommand command, Withdrawal why) {
        lines.add(why + " " + command.commandId());
    }

    @Override
    public void onProgress(String boatId, BoatCommand command, int visitedCount) {
        lines.add("visited " + visitedCount + " of " + command.commandId());
    }

    @Override
    public void onStatus(BoatStatus status) {
        statuses++;
    }

    @Override
    public void onLinkChange(BoatStatus status) {
        lines.add("link " + status.link());
    }

    @Override
    public void onBattery(String boatId, BatteryState battery) {
        lines.add("battery " + battery.level());
    }

    @Override
    public void onRestarted(BoatStatus status) {
        lines.add("restarted");
    }
}
