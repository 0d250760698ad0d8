package org.sami.crw.sim.hull;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.handler.planning.CrwServices;

/** The conditions that have a name (docs/command-line.md); options, journals and messages have them in lower case. */
public enum NamedConditions {
    /** Still water, exact instruments. */
    CALM(Conditions.CALM),
    /** A lake on an ordinary day. */
    FIELD(Conditions.FIELD),
    /** What a hull of 3 m/s still makes headway in. */
    ROUGH(Conditions.ROUGH),
    /** The water of a lake on an ordinary day, with a receiver and a compass as the boats' logs have them. */
    LOGGED(Conditions.LOGGED);

    private static final String SETTING = "conditions";
    private static final String WATER = "water";

    private final Conditions conditions;

    NamedConditions(Conditions conditions) {
        this.conditions = conditions;
    }

    /** The name, as options print and read it. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** What they are like. */
    public Conditions conditions() {
        return conditions;
    }

    /** Services that plan for boats which report no cross-track error as if they were in these conditions. */
    public CrwServices services() {
        return CrwServices.STANDARD.drivenWith(conditions.crossTrackError());
    }

    /** What the header of a session's journal holds of it. */
    public Map<String, String> settings() {
        return Map.of(SETTING, toString());
    }

    /** Those that the header of a session's journal names; field where it names none. */
    public static NamedConditions of(Map<String, String> settings) {
        return named(settings.getOrDefault(SETTING, "")).orElse(FIELD);
    }

    /** What the header of a session's journal holds where these are those of its simulated boats. */
    public Map<String, String> waterSettings() {
        return Map.of(WATER, toString());
    }

    /** Those of simulated boats that the header of a session's journal names; empty where it names none: still water. */
    public static Optional<NamedConditions> ofWater(Map<String, String> settings) {
        return named(settings.getOrDefault(WATER, ""));
    }

    /** The conditions of a name, as options have it; empty where none has it. */
    public static Optional<NamedConditions> named(String name) {
        return Arrays.stream(values())
                .filter(one -> one.toString().equals(name))
                .findFirst();
    }
}
