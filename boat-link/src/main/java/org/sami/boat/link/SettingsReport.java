package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;
import java.util.Optional;

/**
 * The settings in force on the boat, and how its control board is. Sent with every welcome, and to all clients after the answer to a command that changed one, or
 * when the board's condition has changed: the sender sees the result, and observers see the change.
 */
public final class SettingsReport extends LinkMessage {
    static final String TYPE = "settings";
    private static final String HOME = "home";
    private static final String ERROR = "error";
    private static final String STOPPED_BY = "stoppedBy";
    private static final String BOARD = "board";
    private static final String PERFORMANCE = "performance";
    private static final String ACTION_BY = "actionBy";

    private final Gains heading;
    private final Gains speed;
    private final double velocityMultiplier;
    private final LostLinkAction lostLinkAction;
    private final Optional<Waypoint> home;
    private final Optional<TrackingError> error;
    private final String stoppedBy;
    private final Optional<BoardCondition> board;
    private final BoatPerformance performance;
    private final BoatCapabilities capabilities;
    private final String actionBy;

    /** The report of an older boat, which sends neither its home nor its errors. */
    public SettingsReport(Gains heading, Gains speed, double velocityMultiplier, LostLinkAction lostLinkAction) {
        this(heading, speed, velocityMultiplier, lostLinkAction, Optional.empty(), Optional.empty());
    }

    /** The report of a boat whose fleet stop is not latched, or of an older one, which does not say who latched it. */
    public SettingsReport(
            Gains heading,
            Gains speed,
            double velocityMultiplier,
            LostLinkAction lostLinkAction,
            Optional<Waypoint> home,
            Optional<TrackingError> error) {
        this(heading, speed, velocityMultiplier, lostLinkAction, home, error, "");
    }

    /** The report of a boat without a control board, or of an older one, which does not say how it is. */
    public SettingsReport(
            Gains heading,
            Gains speed,
            double velocityMultiplier,
            LostLinkAction lostLinkAction,
            Optional<Waypoint> home,
            Optional<TrackingError> error,
            String stoppedBy) {
        this(heading, speed, velocityMultiplier, lostLinkAction, home, error, stoppedBy, Optional.empty());
    }

    /**
     * Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param home where the boat returns to, at the speed at which it does
     * @param error how far the boat may be off its path, if it knows
     * @param stoppedBy the client that has latched the fleet stop; empty where it is not latched, or the client is not known
     * @param board how its control board is; empty for a boat without one
     */
    public SettingsReport(
            Gains heading,
            Gains speed,
            double velocityMultiplier,
            LostLinkAction lostLinkAction,
            Optional<Waypoint> home,
            Optional<TrackingError> error,
            String stoppedBy,
            Optional<BoardCondition> board) {
        this(
                heading,
                speed,
                velocityMultiplier,
                lostLinkAction,
                home,
                error,
                stoppedBy,
                board,
                BoatPerformance.UNKNOWN,
                BoatCapabilities.UNKNOWN,
                "");
    }

    private SettingsReport(
            Gains heading,
            Gains speed,
            double velocityMultiplier,
            LostLinkAction lostLinkAction,
            Optional<Waypoint> home,
            Optional<TrackingError> error,
            String stoppedBy,
            Optional<BoardCondition> board,
            BoatPerformance performance,
            BoatCapabilities capabilities,
            String actionBy) {
        this.heading = Objects.requireNonNull(heading, "heading");
        this.speed = Objects.requireNonNull(speed, "speed");
        this.velocityMultiplier =
                Checks.range("multiplier", velocityMultiplier, 0, SetVelocityMultiplier.MAX_MULTIPLIER);
        this.lostLinkAction = Objects.requireNonNull(lostLinkAction, "lostLinkAction");
        this.home = Objects.requireNonNull(home, "home");
        this.error = Objects.requireNonNull(error, "error");
        this.stoppedBy = Checks.optionalName(STOPPED_BY, stoppedBy);
        this.board = Objects.requireNonNull(board, BOARD);
        this.performance = Objects.requireNonNull(performance, PERFORMANCE);
        this.capabilities = Objects.requireNonNull(capabilities, "capabilities");
        this.actionBy = Checks.text(ACTION_BY, actionBy);
    }

    /** The same report of a boat that says how far, how fast and how narrowly it drives. */
    public SettingsReport with(BoatPerformance newPerformance) {
        return new SettingsReport(
                heading,
                speed,
                velocityMultiplier,
                lostLinkAction,
                home,
                error,
                stoppedBy,
                board,
                newPerformance,
                capabilities,
                actionBy);
    }

    /** The same report of a boat that says what it cannot do and what it measures. */
    public SettingsReport with(BoatCapabilities newCapabilities) {
        return new SettingsReport(
                heading,
                speed,
                velocityMultiplier,
                lostLinkAction,
                home,
                error,
                stoppedBy,
                board,
                performance,
                newCapabilities,
                actionBy);
    }

    /**
     * The same report of a boat that says which of its own settings make it do what it does without a link.
     *
     * @param settings in the words of the boat's maker, such as {@code FS_GCS_ENABLE 0}; empty text where it does not say it
     */
    public SettingsReport withActionBy(String settings) {
        return new SettingsReport(
                heading,
                speed,
                velocityMultiplier,
                lostLinkAction,
                home,
                error,
                stoppedBy,
                board,
                performance,
                capabilities,
                settings);
    }

    static SettingsReport read(Fields in) throws LinkException {
        return new SettingsReport(
                Gains.read(in.object("heading")),
                Gains.read(in.object("speed")),
                in.number("multiplier"),
                in.word("action", LostLinkAction.class),
                in.has(HOME) ? Optional.of(WaypointRows.readRow(in.array(HOME), "/" + HOME)) : Optional.empty(),
                in.has(ERROR) ? Optional.of(TrackingError.read(in.object(ERROR))) : Optional.empty(),
                in.textOrEmpty(STOPPED_BY),
                in.has(BOARD) ? Optional.of(in.word(BOARD, BoardCondition.class)) : Optional.empty(),
                in.has(PERFORMANCE) ? BoatPerformance.read(in.object(PERFORMANCE)) : BoatPerformance.UNKNOWN,
                BoatCapabilities.read(in),
                in.textOrEmpty(ACTION_BY));
    }

    /** Gains of a control loop. */
    public Gains gains(GainAxis axis) {
        return axis == GainAxis.HEADING ? heading : speed;
    }

    /** Factor on the speed of every leg. */
    public double velocityMultiplier() {
        return velocityMultiplier;
    }

    /** What the boat does when the link to its commander is lost. */
    public LostLinkAction lostLinkAction() {
        return lostLinkAction;
    }

    /** Which of the boat's own settings make it do that, in the words of its maker; empty text where it does not say it. */
    public String actionBy() {
        return actionBy;
    }

    /** Where the boat returns to, and how fast; a boat that tells this takes {@link SetWaysHome}. */
    public Optional<Waypoint> home() {
        return home;
    }

    /** The boat's cross-track error; empty where it does not know it. */
    public Optional<TrackingError> error() {
        return error;
    }

    /** The client that has latched the fleet stop; empty where it is not latched, or the client is not known. */
    public String stoppedBy() {
        return stoppedBy;
    }

    /** How its control board is; empty for a boat without one, and for older ones. */
    public Optional<BoardCondition> board() {
        return board;
    }

    /** How far, how fast and how narrowly the boat drives; {@link BoatPerformance#UNKNOWN} for older boats. */
    public BoatPerformance performance() {
        return performance;
    }

    /** What the boat cannot do, and what it measures; {@link BoatCapabilities#UNKNOWN} for older boats. */
    public BoatCapabilities capabilities() {
        return capabilities;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeObjectFieldStart("heading");
        heading.write(out);
        out.writeEndObject();
        out.writeObjectFieldStart("speed");
        speed.write(out);
        out.writeEndObject();
        out.writeNumberField("multiplier", velocityMultiplier);
        out.writeStringField("action", lostLinkAction.name());
        if (!actionBy.isEmpty()) {
            out.writeStringField(ACTION_BY, actionBy);
        }
        if (home.isPresent()) {
            out.writeFieldName(HOME);
            WaypointRows.writeRow(out, home.get());
        }
        if (error.isPresent()) {
            out.writeObjectFieldStart(ERROR);
            error.get().write(out);
            out.writeEndObject();
        }
        if (!stoppedBy.isEmpty()) {
            out.writeStringField(STOPPED_BY, stoppedBy);
        }
        if (board.isPresent()) {
            out.writeStringField(BOARD, board.get().name());
        }
        if (!performance.isUnknown()) {
            out.writeObjectFieldStart(PERFORMANCE);
            performance.write(out);
            out.writeEndObject();
        }
        capabilities.write(out);
    }
}
