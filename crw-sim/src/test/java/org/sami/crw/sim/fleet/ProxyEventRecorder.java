package org.sami.crw.sim.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatStatus;

/** Writes down all that a proxy reports, telemetry apart. */
final class ProxyEventRecorder implements Consumer<FleetEvent> {
    final List<String> lines = new ArrayList<>();
    int statuses;

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.CommandCompleted done) {
            onCompleted(done.command());
        } else if (event instanceof FleetEvent.CommandFailed failed) {
            onFailed(failed.command(), failed.reason());
        } else if (event instanceof FleetEvent.CommandWithdrawn withdrawn) {
            onWithdrawn(withdrawn.command(), withdrawn.why());
        } else if (event instanceof FleetEvent.Progressed progressed) {
            onProgress(progressed.command(), progressed.visited());
        } else if (event instanceof FleetEvent.StatusReported) {
            onStatus();
        } else if (event instanceof FleetEvent.LinkChanged link) {
            onLinkChange(link.status());
        } else if (event instanceof FleetEvent.BatteryReported battery) {
            onBattery(battery.battery());
        } else if (event instanceof FleetEvent.Restarted) {
            onRestarted();
        }
    }

    private void onCompleted(BoatCommand command) {
        lines.add("completed " + command.commandId());
    }

    private void onFailed(BoatCommand command, String reason) {
        lines.add("failed " + command.commandId() + ": " + reason);
    }

    private void onWithdrawn(BoatCommand command, Withdrawal why) {
        lines.add(why + " " + command.commandId());
    }

    private void onProgress(BoatCommand command, int visitedCount) {
        lines.add("visited " + visitedCount + " of " + command.commandId());
    }

    private void onStatus() {
        statuses++;
    }

    private void onLinkChange(BoatStatus status) {
        lines.add("link " + status.link());
    }

    private void onBattery(BatteryState battery) {
        lines.add("battery " + battery.level());
    }

    private void onRestarted() {
        lines.add("restarted");
    }
}
