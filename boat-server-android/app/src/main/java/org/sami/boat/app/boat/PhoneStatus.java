package org.sami.boat.app.boat;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.hull.board.BoardVehicle;
import org.sami.boat.hull.position.Pose;
import org.sami.boat.hull.position.PositionDoubt;
import org.sami.boat.link.BoatMode;

/** What a person on board wants to know of the boat, at one moment. Immutable. */
public final class PhoneStatus {
    private final String name;
    private final int port;
    private final Serving serving;
    private final Optional<BoatMode> mode;
    private final Optional<String> commandedBy;
    private final int clients;
    private final int bases;
    private final boolean open;
    private final Pose pose;
    private final Set<PositionDoubt> doubts;
    private final BoardState board;
    private final String boardTrouble;
    private final double boardVolts;
    private final double boardPercent;
    private final double phonePercent;
    private final List<String> troubles;
    private final boolean stopped;

    /** How far the server has come. */
    public enum Serving {
        /** It waits until it knows where it is. */
        WAITS_FOR_POSITION,
        /** It serves. */
        SERVES,
        /** It cannot; the troubles say why. */
        FAILED
    }

    PhoneStatus(
            PhoneSettings settings,
            int port,
            Serving serving,
            Optional<BoatMode> mode,
            Optional<String> commandedBy,
            int clients,
            PhoneKeys keys,
            Pose pose,
            Set<PositionDoubt> doubts,
            BoardVehicle hull,
            double phonePercent,
            List<String> troubles,
            boolean stopped) {
        name = settings.name();
        this.port = port;
        this.serving = serving;
        this.mode = mode;
        this.commandedBy = commandedBy;
        this.clients = clients;
        bases = keys.bases().size();
        open = keys.areLinksOpen();
        this.pose = pose;
        this.doubts = Collections.unmodifiableSet(doubts);
        board = hull.boardState();
        boardTrouble = hull.boardTrouble();
        boardVolts = hull.batteryVolts();
        boardPercent = hull.batteryPercent();
        this.phonePercent = phonePercent;
        this.troubles = Collections.unmodifiableList(troubles);
        this.stopped = stopped;
    }

    /** Names the boat. */
    public String name() {
        return name;
    }

    /** Where it serves or will. */
    public int port() {
        return port;
    }

    /** How far the server has come. */
    public Serving serving() {
        return serving;
    }

    /** What the boat does; empty before it serves. */
    public Optional<BoatMode> mode() {
        return mode;
    }

    /** Who commands; empty for nobody. */
    public Optional<String> commandedBy() {
        return commandedBy;
    }

    /** How many clients are connected. */
    public int clients() {
        return clients;
    }

    /** How many bases are paired. */
    public int bases() {
        return bases;
    }

    /** Whether anybody commands it, paired or not. */
    public boolean areLinksOpen() {
        return open;
    }

    /** Where it is. */
    public Pose pose() {
        return pose;
    }

    /** What is doubtful about it. */
    public Set<PositionDoubt> doubts() {
        return doubts;
    }

    /** Whether the board is there. */
    public BoardState board() {
        return board;
    }

    /** Why it is not. */
    public String boardTrouble() {
        return boardTrouble;
    }

    /** Voltage of the boat's battery; NaN if unknown. */
    public double boardVolts() {
        return boardVolts;
    }

    /** Charge of the boat's battery in percent. */
    public double boardPercent() {
        return boardPercent;
    }

    /** Charge of the phone's battery in percent; NaN if unknown. */
    public double phonePercent() {
        return phonePercent;
    }

    /** What else is not well, in words. */
    public List<String> troubles() {
        return troubles;
    }

    /** Whether it is stopped on board. */
    public boolean isStopped() {
        return stopped;
    }
}
