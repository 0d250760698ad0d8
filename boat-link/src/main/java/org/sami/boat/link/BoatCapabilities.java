package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.boat.link.LinkException.Fault;

/** What a boat cannot do, each with the reason, and what it measures, as far as it says so. Immutable. */
public final class BoatCapabilities {
    /** A boat that says nothing of it: it may be able to do anything. */
    public static final BoatCapabilities UNKNOWN = new BoatCapabilities(Collections.emptyMap(), Optional.empty());

    /** Pictures all round, as {@link TakePanorama} asks for them. */
    public static final String PANORAMA = TakePanorama.TYPE;

    /** Gains of its control loops, as {@link SetGains} sets them. */
    public static final String GAINS = SetGains.TYPE;

    /** Ways home around what it is to avoid, as {@link SetWaysHome} sets them. */
    public static final String WAYS_HOME = SetWaysHome.TYPE;

    /** Reports of its charge in percent; no command. A boat that cannot reports at most that its battery is critical. */
    public static final String CHARGE = BatteryReport.TYPE;

    /** Most channels that are said. */
    public static final int MOST_CHANNELS = 64;

    private static final String CANNOT = "cannot";
    private static final String WHAT = "what";
    private static final String WHY = "why";
    private static final String MEASURES = "measures";
    private static final int MOST_MISSING = 32;

    private final Map<String, String> cannot;
    private final Optional<List<String>> measures;

    /**
     * Makes one of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param cannot the types of the commands that the boat always refuses, and {@link #CHARGE}, each with the reason in words; at most 32
     * @param measures the channels that it measures, each as {@code sensor/channel}, at most 64; empty where it does not say
     */
    public BoatCapabilities(Map<String, String> cannot, Optional<List<String>> measures) {
        Checks.range(CANNOT, cannot.size(), 0, MOST_MISSING);
        for (Map.Entry<String, String> one : cannot.entrySet()) {
            Checks.name(WHAT, one.getKey());
            Checks.text(WHY, one.getValue());
        }
        this.cannot = Collections.unmodifiableMap(new TreeMap<>(cannot));
        if (measures.isPresent()) {
            Checks.range(MEASURES, measures.get().size(), 0, MOST_CHANNELS);
            measures.get().forEach(channel -> Checks.id(MEASURES, channel));
        }
        this.measures = measures.map(channels -> Collections.unmodifiableList(new ArrayList<>(channels)));
    }

    static BoatCapabilities read(Fields in) throws LinkException {
        Map<String, String> cannot = new TreeMap<>();
        if (in.has(CANNOT)) {
            for (Fields one : in.objects(CANNOT, MOST_MISSING)) {
                cannot.put(one.text(WHAT), one.text(WHY));
            }
        }
        try {
            return new BoatCapabilities(cannot, in.has(MEASURES) ? Optional.of(channels(in)) : Optional.empty());
        } catch (Checks.BadValueException e) {
            throw in.refused(e);
        }
    }

    private static List<String> channels(Fields in) throws LinkException {
        List<String> channels = new ArrayList<>();
        for (JsonNode channel : in.array(MEASURES)) {
            if (!channel.isTextual()) {
                throw new LinkException(Fault.WRONG_TYPE, in.pointer(MEASURES), "not a list of texts");
            }
            channels.add(channel.textValue());
        }
        return channels;
    }

    /** The types of the commands that the boat always refuses, and {@link #CHARGE} of one that reports none, each with the reason in words. */
    public Map<String, String> cannot() {
        return cannot;
    }

    /** The channels that it measures, each as {@code sensor/channel}; empty where it does not say. */
    public Optional<List<String>> measures() {
        return measures;
    }

    /** Whether the boat says anything of it. */
    public boolean isKnown() {
        return measures.isPresent() || !cannot.isEmpty();
    }

    void write(JsonGenerator out) throws IOException {
        if (!cannot.isEmpty()) {
            out.writeArrayFieldStart(CANNOT);
            for (Map.Entry<String, String> one : cannot.entrySet()) {
                out.writeStartObject();
                out.writeStringField(WHAT, one.getKey());
                out.writeStringField(WHY, one.getValue());
                out.writeEndObject();
            }
            out.writeEndArray();
        }
        if (measures.isPresent()) {
            out.writeArrayFieldStart(MEASURES);
            for (String channel : measures.get()) {
                out.writeString(channel);
            }
            out.writeEndArray();
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof BoatCapabilities
                && cannot.equals(((BoatCapabilities) other).cannot)
                && measures.equals(((BoatCapabilities) other).measures);
    }

    @Override
    public int hashCode() {
        return 31 * cannot.hashCode() + measures.hashCode();
    }

    @Override
    public String toString() {
        return "cannot " + cannot + ", measures " + measures;
    }
}
