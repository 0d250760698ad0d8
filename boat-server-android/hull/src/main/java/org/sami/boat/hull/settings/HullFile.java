package org.sami.boat.hull.settings;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import org.sami.boat.link.PowerCurve;

/** The file of a hull's settings: one JSON object, as {@code hull-1.schema.json} says. What is left out is as by default; what is unknown or out of range is refused. */
public final class HullFile {
    /** The format that is written. */
    public static final String FORMAT = "sami-hull-1";

    private static final long MAX_BYTES = 16 * 1024;
    private static final ObjectMapper JSON = new ObjectMapper()
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .enable(DeserializationFeature.FAIL_ON_READING_DUP_TREE_KEY);

    private HullFile() {}

    /**
     * Reads a file.
     *
     * @throws IOException whose message names the file, and where in it something is wrong
     */
    public static HullSettings read(Path file) throws IOException {
        try {
            if (Files.size(file) > MAX_BYTES) {
                throw new IOException(file + ": longer than " + MAX_BYTES + " bytes: this is no file of a hull");
            }
            return parse(new String(Files.readAllBytes(file), StandardCharsets.UTF_8));
        } catch (NoSuchFileException e) {
            throw new IOException("there is no file " + file, e);
        } catch (IllegalArgumentException e) {
            throw new IOException(file + ": " + e.getMessage(), e);
        }
    }

    /**
     * Reads the text of a file.
     *
     * @throws IllegalArgumentException that says where something is wrong
     */
    public static HullSettings parse(String text) {
        JsonNode root;
        try {
            root = JSON.readTree(text);
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("no JSON: " + e.getOriginalMessage(), e);
        }
        if (!root.isObject()) {
            throw new IllegalArgumentException("expected is a JSON object");
        }
        String format = word(root.path("format"), "/format");
        if (!format.equals(FORMAT)) {
            throw new IllegalArgumentException("/format: '" + format + "' is not " + FORMAT);
        }
        HullSettings.Builder hull = HullSettings.of(kind(word(root.path("kind"), "/kind")));
        for (Map.Entry<String, JsonNode> member : root.properties()) {
            try {
                take(hull, member.getKey(), member.getValue());
            } catch (IllegalArgumentException e) {
                String said = String.valueOf(e.getMessage());
                throw new IllegalArgumentException(
                        said.startsWith("/") ? said : "/" + member.getKey() + ": " + said, e);
            }
        }
        return hull.build();
    }

    private static HullKind kind(String word) {
        for (HullKind kind : HullKind.values()) {
            if (word(kind).equals(word)) {
                return kind;
            }
        }
        throw new IllegalArgumentException("/kind: '" + word + "' is neither differential nor rudder");
    }

    private static String word(HullKind kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }

    private static void take(HullSettings.Builder hull, String name, JsonNode value) {
        switch (name) {
            case "format":
            case "kind":
                break;
            case "safeMaximum":
                hull.safeMaximum(number(value));
                break;
            case "trim":
                hull.trim(number(value));
                break;
            case "leftReversed":
                truth(value, hull::leftReversed);
                break;
            case "rightReversed":
                truth(value, hull::rightReversed);
                break;
            case "sidesSwapped":
                truth(value, hull::sidesSwapped);
                break;
            case "rudderReversed":
                truth(value, hull::rudderReversed);
                break;
            case "steeringThrust":
                hull.steeringThrust(number(value));
                break;
            case "turnRateRadPerS":
                hull.turnRateRadPerS(number(value));
                break;
            case "battery":
                battery(hull, value);
                break;
            case "metresPerPercent":
                hull.metresPerPercent(number(value));
                break;
            case "power":
                power(hull, value);
                break;
            case "cruiseMps":
                hull.cruiseMps(number(value));
                break;
            case "turningRadiusM":
                hull.turningRadiusM(number(value));
                break;
            case "motorsChecked":
                truth(value, hull::motorsChecked);
                break;
            default:
                throw new IllegalArgumentException("there is no such setting");
        }
    }

    private static void battery(HullSettings.Builder hull, JsonNode value) {
        if (value.isTextual()) {
            hull.battery(value.asText());
            return;
        }
        if (!value.isObject() || value.size() != 2) {
            throw new IllegalArgumentException("expected is a name, or an object with volts and percent");
        }
        hull.battery(new BatteryCurve(numbers(value, "/battery", "volts"), numbers(value, "/battery", "percent")));
    }

    private static void power(HullSettings.Builder hull, JsonNode value) {
        if (!value.isObject() || value.size() != 2) {
            throw new IllegalArgumentException("expected is an object with speedMps and percentPerHour");
        }
        hull.power(new PowerCurve(numbers(value, "/power", "speedMps"), numbers(value, "/power", "percentPerHour")));
    }

    private static double[] numbers(JsonNode object, String where, String name) {
        JsonNode array = object.path(name);
        if (!array.isArray() || array.size() > BatteryCurve.MAX_POINTS) {
            throw new IllegalArgumentException(
                    where + "/" + name + ": expected are 2 to " + BatteryCurve.MAX_POINTS + " numbers");
        }
        double[] numbers = new double[array.size()];
        for (int i = 0; i < numbers.length; i++) {
            if (!array.path(i).isNumber()) {
                throw new IllegalArgumentException(where + "/" + name + "/" + i + ": expected is a number");
            }
            numbers[i] = array.path(i).asDouble();
        }
        return numbers;
    }

    private static double number(JsonNode value) {
        if (!value.isNumber()) {
            throw new IllegalArgumentException("expected is a number, not " + value);
        }
        return value.asDouble();
    }

    private static void truth(JsonNode value, Consumer<Boolean> setter) {
        if (!value.isBoolean()) {
            throw new IllegalArgumentException("expected is true or false, not " + value);
        }
        setter.accept(value.asBoolean());
    }

    private static String word(JsonNode value, String where) {
        if (!value.isTextual()) {
            throw new IllegalArgumentException(where + ": expected is a text");
        }
        return value.asText();
    }

    /** The text of a file with these settings. */
    public static String text(HullSettings hull) {
        ObjectNode root = JSON.createObjectNode();
        root.put("format", FORMAT);
        root.put("kind", word(hull.kind()));
        root.put("safeMaximum", hull.safeMaximum());
        root.put("trim", hull.trim());
        root.put("leftReversed", hull.leftReversed());
        root.put("rightReversed", hull.rightReversed());
        root.put("sidesSwapped", hull.sidesSwapped());
        root.put("rudderReversed", hull.rudderReversed());
        root.put("steeringThrust", hull.steeringThrust());
        root.put("turnRateRadPerS", hull.turnRateRadPerS());
        if (hull.batteryName().isEmpty()) {
            ObjectNode curve = root.putObject("battery");
            Arrays.stream(hull.battery().volts()).forEach(curve.putArray("volts")::add);
            Arrays.stream(hull.battery().percents()).forEach(curve.putArray("percent")::add);
        } else {
            root.put("battery", hull.batteryName());
        }
        if (hull.performance().power().isPresent()) {
            PowerCurve power = hull.performance().power().get();
            ObjectNode curve = root.putObject("power");
            Arrays.stream(power.speedsMps()).forEach(curve.putArray("speedMps")::add);
            Arrays.stream(power.percentsPerHour()).forEach(curve.putArray("percentPerHour")::add);
        } else {
            hull.performance().metresPerPercent().ifPresent(metres -> root.put("metresPerPercent", metres));
        }
        hull.performance().cruiseMps().ifPresent(mps -> root.put("cruiseMps", mps));
        hull.performance().turningRadiusM().ifPresent(metres -> root.put("turningRadiusM", metres));
        root.put("motorsChecked", hull.motorsChecked());
        return root.toPrettyString() + "\n";
    }

    /** Writes a file, by a rename: whoever reads it finds the old settings or the new ones. */
    public static void write(Path file, HullSettings hull) throws IOException {
        Path folder = file.toAbsolutePath().getParent();
        Path draft = (folder == null ? file : folder.resolve(file.getFileName() + ".new")).toAbsolutePath();
        Files.write(draft, text(hull).getBytes(StandardCharsets.UTF_8));
        Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    }
}
