package org.sami.boat.server;

import java.util.Optional;
import java.util.function.Consumer;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.server.vehicle.Vehicle;

/** Reports the level of the battery and the condition of the control board to all clients when they change. For the thread that ticks the server. */
final class StateReports {
    private final Vehicle vehicle;
    private final BatteryWatch battery;
    private final ModeControl modes;
    private final CommandExecutor executor;
    private BatteryLevel level;
    private Optional<BoardCondition> board;
    private boolean hasCamera;

    /** Reports that begin with the state of now, which each client hears in its welcome. */
    StateReports(Vehicle vehicle, BatteryWatch battery, ModeControl modes, CommandExecutor executor) {
        this.vehicle = vehicle;
        this.battery = battery;
        this.modes = modes;
        this.executor = executor;
        level = battery.level();
        board = modes.board();
        hasCamera = modes.hasCamera();
    }

    /** Lets time pass; clients receive what has changed. */
    void tick(long nowMs, Consumer<LinkMessage> clients) {
        battery.tick(nowMs);
        if (battery.level() != level) {
            level = battery.level();
            clients.accept(battery());
        }
        if (!modes.board().equals(board) || modes.hasCamera() != hasCamera) {
            board = modes.board();
            hasCamera = modes.hasCamera();
            clients.accept(executor.settings());
        }
    }

    /** The charge, and its level. */
    BatteryReport battery() {
        return new BatteryReport(vehicle.batteryPercent(), battery.level());
    }
}
