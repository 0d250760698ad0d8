package org.sami.boat.server;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.UploadWaypoints;

/** Executes each command of the commander once, and answers it. */
final class CommandExecutor {
    private final ServerConfig config;
    private final ModeControl modes;
    private final List<String> channels; // that the boat measures
    private String stoppedBy = ""; // while the fleet stop is latched
    private String alsoStoppedBy = "";
    private LostLinkAction lostLinkAction;

    CommandExecutor(ServerConfig config, ModeControl modes, List<String> channels) {
        this.config = config;
        this.modes = modes;
        this.channels = channels;
        lostLinkAction = config.lostLinkAction();
    }

    LostLinkAction lostLinkAction() {
        return lostLinkAction;
    }

    /** Whether a command changes one of {@link #settings}. */
    static boolean isSetting(CommandMessage command) {
        return command instanceof SetGains
                || command instanceof SetVelocityMultiplier
                || command instanceof SetLostLinkAction;
    }

    /** Whether a command latches or releases the fleet stop; the settings name who latched it. */
    static boolean isLatch(CommandMessage command) {
        return command instanceof FleetStop || command instanceof FleetRelease;
    }

    /** Whether a command starts motion or releases a latched stop. */
    static boolean isMoving(CommandMessage command) {
        return command instanceof StartWaypoints
                || command instanceof TakePanorama
                || command instanceof HoldPosition
                || command instanceof FleetRelease;
    }

    /** The settings in force. */
    SettingsReport settings() {
        SettingsReport inForce = new SettingsReport(
                modes.steering().gains(GainAxis.HEADING),
                modes.steering().gains(GainAxis.SPEED),
                modes.path().velocityMultiplier(),
                lostLinkAction,
                Optional.of(modes.homeward().home().origin(config.returnSpeedMps())),
                config.trackingError(),
                isFleetStopped() ? stoppedBy : "",
                modes.board());
        return inForce.with(config.performance()).with(capabilities());
    }

    private BoatCapabilities capabilities() {
        return new BoatCapabilities(
                modes.hasCamera()
                        ? Collections.emptyMap()
                        : Collections.singletonMap(BoatCapabilities.PANORAMA, modes.cameraTrouble()),
                Optional.of(channels));
    }

    /**
     * Executes a command.
     *
     * @param clientId who sent it; empty if that is not known
     */
    LinkMessage execute(String clientId, CommandMessage command) {
        if (command instanceof UploadWaypoints) {
            return upload((UploadWaypoints) command);
        } else if (command instanceof StartWaypoints) {
            return start((StartWaypoints) command);
        } else if (command instanceof SetWaysHome) {
            return waysHome((SetWaysHome) command);
        } else if (command instanceof StopMotors) {
            modes.stop();
        } else if (command instanceof HoldPosition) {
            return hold(command);
        } else if (command instanceof TakePanorama) {
            return panorama((TakePanorama) command);
        } else if (command instanceof FleetStop) {
            fleetStop(clientId);
        } else if (command instanceof FleetRelease) {
            modes.release();
        } else {
            set(command);
        }
        return ack(command);
    }

    private void fleetStop(String clientId) {
        if (isFleetStopped()) {
            stopAgain(clientId);
        } else {
            stoppedBy = clientId;
            alsoStoppedBy = "";
            modes.fleetStop();
        }
    }

    /** A client stops a boat whose fleet stop is latched; the latch keeps the name of the first. */
    void stopAgain(String clientId) {
        alsoStoppedBy = clientId.equals(stoppedBy) ? alsoStoppedBy : clientId;
    }

    /** The newest client other than the first that has stopped the boat while its stop is latched; empty for none. */
    Optional<String> alsoStoppedBy() {
        return Optional.of(alsoStoppedBy).filter(client -> isFleetStopped() && !client.isEmpty());
    }

    private LinkMessage upload(UploadWaypoints command) {
        int size = command.waypoints().size();
        if (size > config.maxWaypoints()) {
            return nack(command, NackReason.TOO_LONG, size + " waypoints; this boat keeps " + config.maxWaypoints());
        }
        modes.replaceTrack(new WaypointTrack(command.listId(), command.waypoints()));
        return ack(command);
    }

    private LinkMessage start(StartWaypoints command) {
        WaypointTrack track = modes.path().track();
        if (modes.denies(ModeEvent.START)) {
            return fleetStopped(command);
        }
        if (!track.listId().equals(command.listId())) {
            return unknownList(command);
        }
        if (command.index() > track.size()) {
            return nack(command, NackReason.BAD_INDEX, "index " + command.index() + " of " + track.size());
        }
        modes.follow(command.index());
        return ack(command);
    }

    private LinkMessage waysHome(SetWaysHome command) {
        if (!modes.path().track().listId().equals(command.listId())) {
            return unknownList(command);
        }
        modes.path().setWaysHome(command);
        return ack(command);
    }

    private LinkMessage unknownList(CommandMessage command) {
        return nack(
                command,
                NackReason.UNKNOWN_LIST,
                "this boat holds " + named(modes.path().track().listId()));
    }

    private LinkMessage hold(CommandMessage command) {
        if (modes.denies(ModeEvent.HOLD_POSITION)) {
            return fleetStopped(command);
        }
        modes.hold();
        return ack(command);
    }

    private LinkMessage panorama(TakePanorama command) {
        if (modes.denies(ModeEvent.PANORAMA)) {
            return fleetStopped(command);
        }
        if (!modes.hasCamera()) {
            return nack(command, NackReason.NO_CAMERA, modes.cameraTrouble());
        }
        modes.takePanorama(command);
        return ack(command);
    }

    private void set(CommandMessage command) {
        if (command instanceof SetGains) {
            SetGains set = (SetGains) command;
            modes.steering().setGains(set.axis(), set.gains());
        } else if (command instanceof SetVelocityMultiplier) {
            modes.path().setVelocityMultiplier(((SetVelocityMultiplier) command).multiplier());
        } else if (command instanceof SetLostLinkAction) {
            lostLinkAction = ((SetLostLinkAction) command).action();
        } else {
            throw new IllegalStateException("no way to execute a " + command.type());
        }
    }

    private boolean isFleetStopped() {
        return modes.mode() == BoatMode.FLEET_STOP;
    }

    private static String named(String listId) {
        return listId.isEmpty() ? "no list" : listId;
    }

    private static LinkMessage ack(CommandMessage command) {
        return new Ack(command.commandId());
    }

    private static LinkMessage fleetStopped(CommandMessage command) {
        return nack(command, NackReason.FLEET_STOPPED, "the boat is stopped until it is released");
    }

    static LinkMessage nack(CommandMessage command, NackReason reason, String detail) {
        return new Nack(command.commandId(), reason, detail);
    }
}
