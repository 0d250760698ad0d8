package org.sami.crw.sim.vessel;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import org.sami.crw.sim.hull.Conditions;

/**
 * The foreign vessels of a simulated water, as a file says it (docs/command-line.md). Immutable.
 *
 * @param sightM how far boats see, in metres
 */
public record ForeignVessels(List<ForeignVessel> vessels, double sightM) {
    /** How far boats see where a file does not say it, in metres. */
    public static final double USUAL_SIGHT_M = 60;

    /** The most vessels on one water. */
    public static final int MOST = 50;

    /** Nobody else is on the water. */
    public static final ForeignVessels NONE = new ForeignVessels(List.of(), USUAL_SIGHT_M);

    private static final String FORMAT = "crw-vessels";
    private static final ObjectMapper MAPPER = new ObjectMapper();

    public ForeignVessels {
        vessels = List.copyOf(vessels);
        if (vessels.size() > MOST) {
            throw new IllegalArgumentException(vessels.size() + " vessels are more than " + MOST);
        }
        if (!(sightM >= 5 && sightM <= 1000)) {
            throw new IllegalArgumentException("boats see 5 to 1000 m far, not " + sightM);
        }
    }

    public boolean isEmpty() {
        return vessels.isEmpty();
    }

    /** Where all are, so many seconds after the start, in their order. */
    public List<VesselState> at(double seconds, Conditions water) {
        return vessels.stream().map(vessel -> vessel.at(seconds, water)).toList();
    }

    /**
     * Reads a file's text.
     *
     * @throws IllegalArgumentException saying what is wrong with it
     */
    public static ForeignVessels parse(String text) {
        JsonNode file;
        try {
            file = MAPPER.readTree(text);
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("no JSON: " + e.getOriginalMessage(), e);
        }
        if (!FORMAT.equals(file.path("format").asText())) {
            throw new IllegalArgumentException("a file of vessels begins with \"format\": \"" + FORMAT + "\"");
        }
        known(file, "the file", List.of("format", "sight", "vessels"));
        List<ForeignVessel> vessels = new ArrayList<>();
        for (JsonNode vessel : file.path("vessels")) {
            vessels.add(vessel(vessel, "/vessels/" + vessels.size()));
        }
        return new ForeignVessels(vessels, file.has("sight") ? number(file, "sight", "the file") : USUAL_SIGHT_M);
    }

    private static ForeignVessel vessel(JsonNode vessel, String at) {
        known(vessel, at, List.of("name", "length", "beam", "track", "drifts"));
        List<ForeignVessel.TrackPlace> track = new ArrayList<>();
        for (JsonNode fix : vessel.path("track")) {
            String place = at + "/track/" + track.size();
            known(fix, place, List.of("at", "east", "north"));
            track.add(new ForeignVessel.TrackPlace(
                    fix.has("at") ? number(fix, "at", place) : 0,
                    number(fix, "east", place),
                    number(fix, "north", place)));
        }
        return new ForeignVessel(
                vessel.path("name").asText(),
                number(vessel, "length", at),
                number(vessel, "beam", at),
                track,
                vessel.path("drifts").asBoolean(false));
    }

    private static void known(JsonNode object, String at, List<String> names) {
        object.fieldNames().forEachRemaining(name -> {
            if (!names.contains(name)) {
                throw new IllegalArgumentException(at + ": \"" + name + "\" is none of " + String.join(", ", names));
            }
        });
    }

    private static double number(JsonNode object, String name, String at) {
        JsonNode value = object.path(name);
        if (!value.isNumber()) {
            throw new IllegalArgumentException(at + ": \"" + name + "\" is a number");
        }
        return value.asDouble();
    }

    /** What {@link #parse} reads. */
    @Override
    public String toString() {
        ObjectNode file = MAPPER.createObjectNode();
        file.put("format", FORMAT).put("sight", sightM);
        ArrayNode all = file.putArray("vessels");
        for (ForeignVessel vessel : vessels) {
            ObjectNode one = all.addObject();
            one.put("name", vessel.name()).put("length", vessel.lengthM()).put("beam", vessel.beamM());
            if (vessel.drifts()) {
                one.put("drifts", true);
            }
            ArrayNode track = one.putArray("track");
            vessel.track()
                    .forEach(fix -> track.addObject()
                            .put("at", fix.atS())
                            .put("east", fix.eastM())
                            .put("north", fix.northM()));
        }
        return file.toString();
    }
}
