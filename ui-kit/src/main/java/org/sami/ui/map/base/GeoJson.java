package org.sami.ui.map.base;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Reads the outlines of a GeoJSON document (RFC 7946) as a stream, from its first to its last byte: what is kept of it at any time is what will
 * be shown. Members may come in any order; those that are not known are passed over.
 */
final class GeoJson {
    private static final int DEEPEST = 64;
    private static final int LONGEST_WORD = 1000; // of the document that is shown in a message
    private static final JsonFactory JSON = JsonFactory.builder()
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(DEEPEST)
                    .maxStringLength(1_000_000)
                    .maxNameLength(10_000)
                    .maxNumberLength(200)
                    .build())
            .enable(StreamReadFeature.USE_FAST_DOUBLE_PARSER)
            .build();

    private final JsonParser in;
    private final OutlineCollector found;

    private GeoJson(JsonParser in, OutlineCollector found) {
        this.in = in;
        this.found = found;
    }

    /**
     * Reads a file, or a pipe; takes as long as it does, and ends when its thread is interrupted.
     *
     * @throws IOException with the file's name, the place and what is wrong, if it is no GeoJSON or holds nothing
     */
    static OutlineCollector read(Path file, MapFileLimits budget) throws IOException {
        if (!Files.exists(file) || Files.isDirectory(file)) {
            throw new IOException("There is no map file " + file);
        }
        OutlineCollector found = new OutlineCollector(file, budget);
        try (InputStream text = Files.newInputStream(file);
                JsonParser in = JSON.createParser(text)) {
            try {
                new GeoJson(in, found).document();
            } catch (OutlineCollector.Full full) {
                found.endInPart();
            } catch (JsonProcessingException | CharConversionException | GeoJsonFault e) {
                String said = e instanceof JsonProcessingException json ? json.getOriginalMessage() : e.getMessage();
                String kind = e instanceof GeoJsonFault ? " is no GeoJSON, " : " is no JSON, ";
                throw new IOException(file + kind + place(in) + ": " + MapFileLimits.cut(String.valueOf(said), 200), e);
            }
        }
        if (found.isEmpty()) {
            throw new IOException(file + " holds no point, line or area: nothing of it can be shown");
        }
        return found;
    }

    private static String place(JsonParser in) {
        return "line " + in.currentLocation().getLineNr() + ", column "
                + in.currentLocation().getColumnNr();
    }

    private void document() throws IOException {
        if (in.nextToken() != JsonToken.START_OBJECT) {
            throw new GeoJsonFault("it does not begin with an object");
        }
        object(Optional.empty(), true);
        if (in.nextToken() != null) {
            throw new GeoJsonFault("something follows the end of the document");
        }
    }

    /**
     * Reads an object, whose start was read, to its end.
     *
     * @param mustBeKnown whether it has to say of which type it is
     */
    private void object(Optional<String> nameOutside, boolean mustBeKnown) throws IOException {
        String type = "";
        Optional<String> name = nameOutside;
        CoordinateRuns coordinates = found.begin();
        boolean hasGeometry = false;
        int named = found.named();
        while (in.nextToken() == JsonToken.FIELD_NAME) {
            String member = in.currentName();
            JsonToken value = in.nextToken();
            switch (member) {
                case "type" -> type = value == JsonToken.VALUE_STRING ? MapFileLimits.cut(in.getText(), 40) : "";
                case "coordinates" -> coordinates(coordinates, value);
                case "geometry", "features", "geometries" -> {
                    hasGeometry = true;
                    children(value, name);
                }
                case "properties" -> name = properties(value).or(() -> nameOutside);
                default -> in.skipChildren();
            }
            found.look();
        }
        boolean known = GeometryType.of(type).isPresent();
        boolean isFeature =
                List.of("Feature", "FeatureCollection", "GeometryCollection").contains(type);
        if (!known && !isFeature && (mustBeKnown || hasGeometry || !coordinates.isEmpty())) {
            throw new GeoJsonFault("'" + type + "' is no type of it");
        }
        if (type.equals("Feature")) {
            name.ifPresent(of -> found.name(named, of)); // it may stand behind the geometry
        }
        if (known) {
            found.take(GeometryType.of(type).orElseThrow(), coordinates, name.orElse(""));
        }
    }

    private void children(JsonToken value, Optional<String> name) throws IOException {
        if (value == JsonToken.START_OBJECT) {
            object(name, true);
        } else if (value == JsonToken.START_ARRAY) {
            for (JsonToken next = in.nextToken(); next != JsonToken.END_ARRAY; next = in.nextToken()) {
                if (next != JsonToken.START_OBJECT) {
                    throw new GeoJsonFault("a feature or geometry is an object");
                }
                object(name, true);
            }
        } else if (value != JsonToken.VALUE_NULL) {
            throw new GeoJsonFault("a geometry is an object or null");
        }
    }

    /** The name among the properties of a feature. */
    private Optional<String> properties(JsonToken value) throws IOException {
        if (value != JsonToken.START_OBJECT) {
            in.skipChildren();
            return Optional.empty();
        }
        Optional<String> name = Optional.empty();
        while (in.nextToken() == JsonToken.FIELD_NAME) {
            boolean isName = in.currentName().equals("name");
            JsonToken next = in.nextToken();
            if (isName && next == JsonToken.VALUE_STRING) {
                name = Optional.of(MapFileLimits.cut(in.getText(), MapFileLimits.NAME_LETTERS));
            } else {
                in.skipChildren();
            }
        }
        return name;
    }

    private void coordinates(CoordinateRuns into, JsonToken value) throws IOException {
        if (value == JsonToken.VALUE_NULL) {
            return;
        }
        if (value != JsonToken.START_ARRAY) {
            throw new GeoJsonFault("coordinates are a list, not " + word());
        }
        list(into, 1);
    }

    /** A list of lists, or of numbers, whose start was read, to its end. */
    private void list(CoordinateRuns into, int depth) throws IOException {
        if (depth > CoordinateRuns.DEEPEST) {
            throw new GeoJsonFault("coordinates are nested too deep");
        }
        JsonToken next = in.nextToken();
        if (next != null && next.isNumeric()) {
            position(into, depth);
            return;
        }
        while (next == JsonToken.START_ARRAY) {
            list(into, depth + 1);
            next = in.nextToken();
        }
        if (next != JsonToken.END_ARRAY) {
            throw new GeoJsonFault("a position is [longitude, latitude], not " + word());
        }
        into.end(depth);
    }

    /** Longitude comes first in GeoJSON; a third number is an altitude, and more are allowed. */
    private void position(CoordinateRuns into, int depth) throws IOException {
        double lonDeg = in.getDoubleValue();
        if (!in.nextToken().isNumeric()) {
            throw new GeoJsonFault("a position is [longitude, latitude], not " + word());
        }
        double latDeg = in.getDoubleValue();
        for (JsonToken next = in.nextToken(); next != JsonToken.END_ARRAY; next = in.nextToken()) {
            if (next == null || !next.isNumeric()) {
                throw new GeoJsonFault("a position is a list of numbers, and has " + word());
            }
        }
        if (!(Math.abs(lonDeg) <= 180) || !(Math.abs(latDeg) <= 90)) {
            throw new GeoJsonFault("[" + lonDeg + ", " + latDeg + "] is not on the globe: degrees are expected"
                    + " (longitude, latitude, WGS 84); a file in metres has to be converted first");
        }
        into.position(lonDeg, latDeg, depth);
        found.look();
    }

    /** What stands here, in few letters. */
    private String word() throws IOException {
        JsonToken token = in.currentToken();
        if (token == null) {
            return "the end of the file";
        }
        return switch (token) {
            case START_OBJECT -> "an object";
            case START_ARRAY -> "a list";
            case END_ARRAY -> "the end of a list";
            case VALUE_STRING -> "a text";
            default ->
                "'"
                        + MapFileLimits.cut(
                                in.getText().substring(0, Math.min(in.getText().length(), LONGEST_WORD)), 40)
                        + "'";
        };
    }
}
