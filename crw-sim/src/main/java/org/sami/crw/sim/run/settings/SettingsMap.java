package org.sami.crw.sim.run.settings;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.layer.CurrentField;
import org.sami.crw.sim.layer.DepthGrid;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.vessel.ForeignVessels;

/** The settings of a run as text by name, as they stand in the header of its journal. */
public final class SettingsMap {
    private static final String PARAMETER = "set.";
    private static final String BATTERY = "battery";
    private static final String CONNECT = "connect";
    private static final String INTERRUPT = "interrupt.";
    private static final String ALSO = "also.";
    private static final String RANGE = "rangeM";
    private static final String ENERGY = "energy";
    private static final String ROBOTS = "robots";
    private static final String COPTERS = "copters";
    private static final String RADIO = "radio";
    private static final String VESSELS = "vessels";
    private static final String DEPTHS = "depths";
    private static final String CURRENTS = "currents";

    private SettingsMap() {}

    /** Whether robots that fly are among those of settings that were written. */
    public static boolean hasCopters(Map<String, String> map) {
        return RobotKind.COPTER.word().equals(map.get(ROBOTS)) || Integer.parseInt(map.getOrDefault(COPTERS, "0")) > 0;
    }

    /** As text by name. */
    public static Map<String, String> write(RunSettings settings) {
        Map<String, String> map = new TreeMap<>();
        FleetSettings fleet = settings.fleet();
        map.put("plan", settings.plan());
        map.put("mission", settings.mission());
        map.put("boats", String.valueOf(fleet.boats()));
        map.put("locations", String.valueOf(fleet.locations()));
        map.put("areaM", String.valueOf(fleet.areaM()));
        map.put("seed", String.valueOf(fleet.seed()));
        map.put("speed", settings.speed().toString());
        settings.limitMillis().ifPresent(limit -> map.put("limitMillis", String.valueOf(limit)));
        map.put("answerAfterMillis", String.valueOf(settings.answerAfterMillis()));
        map.put("answers", settings.answers());
        if (settings.isConnected()) {
            map.put(
                    CONNECT,
                    settings.connect().stream().map(BoatAddress::toString).collect(Collectors.joining(",")));
        }
        map.putAll(fleet.inProcess().conditions().toMap());
        map.putAll(fleet.site().toMap());
        if (!fleet.inProcess().charges().equals(InitialCharges.FULL)) {
            map.put(BATTERY, fleet.inProcess().charges().toString());
        }
        fleet.inProcess().rangeM().ifPresent(metres -> map.put(RANGE, String.valueOf(metres)));
        if (!fleet.inProcess().energy().isPerMetre()) {
            map.put(ENERGY, fleet.inProcess().energy().toString());
        }
        if (!fleet.inProcess().radio().isPerfect()) {
            map.put(RADIO, fleet.inProcess().radio().toString());
        }
        if (!fleet.inProcess().vessels().isEmpty()) {
            map.put(VESSELS, fleet.inProcess().vessels().toString());
        }
        WaterLayers layers = fleet.inProcess().layers();
        layers.depths().ifPresent(depths -> map.put(DEPTHS, depths.toString()));
        layers.currents().ifPresent(currents -> map.put(CURRENTS, currents.toString()));
        if (fleet.robots() != RobotKind.BOAT) {
            map.put(ROBOTS, fleet.robots().word());
        }
        if (fleet.copters() > 0) {
            map.put(COPTERS, String.valueOf(fleet.copters()));
        }
        settings.parameters().forEach((name, value) -> map.put(PARAMETER + name, value));
        number(map, INTERRUPT, settings.interrupts());
        number(map, ALSO, settings.also());
        return map;
    }

    /**
     * Reads what {@link #write} wrote; names that it does not know are left alone.
     *
     * @throws IllegalArgumentException where something is missing or makes no sense
     */
    public static RunSettings read(Map<String, String> map) {
        Map<String, String> parameters = new TreeMap<>();
        map.forEach((name, value) -> {
            if (name.startsWith(PARAMETER)) {
                parameters.put(name.substring(PARAMETER.length()), value);
            }
        });
        FleetSettings fleet = new FleetSettings(
                Integer.parseInt(needed(map, "boats")),
                Integer.parseInt(needed(map, "locations")),
                Double.parseDouble(needed(map, "areaM")),
                Long.parseLong(needed(map, "seed")),
                Site.fromMap(map),
                map.containsKey(ROBOTS) ? RobotKind.of(map.get(ROBOTS)) : RobotKind.BOAT,
                Integer.parseInt(map.getOrDefault(COPTERS, "0")),
                inProcess(map));
        RunSettings.Builder settings = RunSettings.of(needed(map, "plan"), needed(map, "mission"), fleet)
                .speed(Speed.parse(needed(map, "speed")))
                .parameters(parameters)
                .answerAfterMillis(Long.parseLong(needed(map, "answerAfterMillis")))
                .answers(needed(map, "answers"))
                .interrupts(numbered(map, INTERRUPT))
                .also(numbered(map, ALSO));
        if (map.containsKey("limitMillis")) {
            settings.limitMillis(Long.parseLong(map.get("limitMillis")));
        }
        if (map.containsKey(CONNECT)) {
            settings.connect(BoatAddress.parseAll(map.get(CONNECT)));
        }
        return settings.build();
    }

    private static InProcessBoats inProcess(Map<String, String> map) {
        return new InProcessBoats(
                Conditions.fromMap(map),
                map.containsKey(BATTERY) ? InitialCharges.parse(map.get(BATTERY)) : InitialCharges.FULL,
                map.containsKey(RANGE)
                        ? OptionalDouble.of(Double.parseDouble(needed(map, RANGE)))
                        : OptionalDouble.empty(),
                map.containsKey(RADIO) ? Radio.parse(needed(map, RADIO)) : Radio.PERFECT,
                map.containsKey(ENERGY) ? Energy.parse(needed(map, ENERGY)) : Energy.PER_METRE,
                map.containsKey(VESSELS) ? ForeignVessels.parse(needed(map, VESSELS)) : ForeignVessels.NONE,
                new WaterLayers(
                        Optional.ofNullable(map.get(DEPTHS)).map(DepthGrid::parse),
                        Optional.ofNullable(map.get(CURRENTS)).map(CurrentField::parse)));
    }

    private static void number(Map<String, String> map, String name, List<String> values) {
        for (int i = 0; i < values.size(); i++) {
            map.put(name + i, values.get(i));
        }
    }

    private static List<String> numbered(Map<String, String> map, String name) {
        List<String> values = new ArrayList<>();
        for (String next = map.get(name + 0); next != null; next = map.get(name + values.size())) {
            values.add(next);
        }
        return values;
    }

    private static String needed(Map<String, String> map, String name) {
        String value = map.get(name);
        if (value == null) {
            throw new IllegalArgumentException("the setting '" + name + "' is missing");
        }
        return value;
    }
}
