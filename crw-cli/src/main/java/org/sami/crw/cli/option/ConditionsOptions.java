package org.sami.crw.cli.option;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.hull.SensorSetting;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options that say what the simulated water is like, and what boats measure in it. */
public final class ConditionsOptions {
    @Option(
            names = "--conditions",
            paramLabel = "NAME",
            converter = ConditionsConverter.class,
            description = "Water and instruments: calm, field (a lake on an ordinary day, noise as measured), rough,"
                    + " logged (field, with positions as rare as in the boats' logs); the options below change single"
                    + " values (default: calm). With connected boats: the errors assumed for those that do not report"
                    + " theirs (default: field).")
    private @Nullable NamedConditions named;

    @Option(
            names = "--gps-noise",
            paramLabel = "METRES",
            description =
                    "Standard deviation of the position that a boat knows, 0 to 100 (default: that of --conditions).")
    private @Nullable Double gpsNoiseM;

    @Option(
            names = "--gps-jumps",
            paramLabel = "METRES",
            description = "How far that position jumps at most, every half minute or so, 0 to 100 (default: likewise).")
    private @Nullable Double gpsJumpM;

    @Option(
            names = "--compass-noise",
            paramLabel = "DEGREES",
            description = "Standard deviation of the heading that a boat knows, 0 to 90 (default: likewise).")
    private @Nullable Double compassNoiseDeg;

    @Option(
            names = "--current",
            paramLabel = "MPS@DEG",
            converter = Flows.class,
            description = "How fast the water flows, and where to: 0.3@90 is 0.3 m/s eastward (default: likewise).")
    private @Nullable Flow current;

    @Option(
            names = "--wind",
            paramLabel = "MPS@DEG",
            converter = Flows.class,
            description = "Speed and origin of the wind: 5@270 is 5 m/s from the west, in gusts; it pushes a "
                    + "hull with 3 %% of its speed (default: likewise).")
    private @Nullable Flow wind;

    @Option(
            names = "--sensor",
            paramLabel = "KIND[@HZ]",
            split = ",",
            converter = Sensors.class,
            description =
                    "Sensors of the boats, with readings per second (one if not given): temperature, conductivity,"
                            + " oxygen, ph. May be given several times.")
    private List<SensorSetting> sensors = new ArrayList<>();

    @Option(
            names = "--discharge-interval",
            paramLabel = "SECONDS",
            defaultValue = "600",
            description = "For how long the battery cost of a metre stays the same for a boat, before it is drawn again"
                    + " within 10 %% of the mean; 0 = ten times a second (default ${DEFAULT-VALUE}).")
    private double dischargeIntervalS;

    /**
     * What they say.
     *
     * @throws IllegalArgumentException if it makes no sense
     */
    public Conditions conditions() {
        return conditions(NamedConditions.CALM);
    }

    /**
     * What they say of simulated boats beside boats that have their own water; the latter are planned with likewise where they do not say how they fare.
     *
     * @throws IllegalArgumentException if it makes no sense
     */
    Conditions ofSimulatedBesides() {
        return conditions(NamedConditions.FIELD);
    }

    private Conditions conditions(NamedConditions usual) {
        Conditions all = (named == null ? usual : named).conditions();
        return new Conditions(
                gpsNoiseM == null ? all.gpsNoiseM() : gpsNoiseM,
                gpsJumpM == null ? all.gpsJumpM() : gpsJumpM,
                compassNoiseDeg == null ? all.compassNoiseDeg() : compassNoiseDeg,
                current == null ? all.current() : current,
                wind == null ? all.wind() : wind,
                sensors,
                dischargeIntervalS,
                all.receiver());
    }

    /**
     * What they say of boats that have their own water: what is planned with for those that do not say how they fare in it.
     *
     * @throws UsageFault for an option that is about the water or the instruments themselves
     */
    Conditions stated() {
        NamedConditions stated = named == null ? NamedConditions.FIELD : named;
        Conditions alone = (named == null ? NamedConditions.CALM : named).conditions();
        if (!conditions().equals(alone)) {
            throw new UsageFault(
                    "with --connect the boats have their own water, instruments and sensors: see 'crw boat --help';"
                            + " simulated boats beside them (--boats) take these options");
        }
        return stated.conditions();
    }

    private static <T> T read(Function<String, T> reader, String text) {
        try {
            return reader.apply(text);
        } catch (IllegalArgumentException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }

    private static final class Flows implements ITypeConverter<Flow> {
        @Override
        public Flow convert(String text) {
            return read(Flow::parse, text);
        }
    }

    private static final class Sensors implements ITypeConverter<SensorSetting> {
        @Override
        public SensorSetting convert(String text) {
            return read(SensorSetting::parse, text);
        }
    }
}
