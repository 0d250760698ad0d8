package org.sami.lessons.course;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.exc.StreamReadException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.MapperFeature;
import com.fasterxml.jackson.databind.cfg.CoercionAction;
import com.fasterxml.jackson.databind.cfg.CoercionInputShape;
import com.fasterxml.jackson.databind.exc.UnrecognizedPropertyException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.type.LogicalType;
import com.fasterxml.jackson.datatype.jdk8.Jdk8Module;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.Reading;

/** Reads the records of a course from JSON, strictly: what a record does not know is an error with its file, line and element. */
public final class LessonJson {
    private static final String CODE = "E-LESSON";

    private static final JsonMapper MAPPER = JsonMapper.builder()
            .addModule(new Jdk8Module())
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .enable(MapperFeature.ACCEPT_CASE_INSENSITIVE_ENUMS)
            .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
            .disable(MapperFeature.ALLOW_COERCION_OF_SCALARS)
            .withCoercionConfig(
                    LogicalType.Textual,
                    text -> text.setCoercion(CoercionInputShape.Boolean, CoercionAction.Fail)
                            .setCoercion(CoercionInputShape.Integer, CoercionAction.Fail)
                            .setCoercion(CoercionInputShape.Float, CoercionAction.Fail))
            .build();

    private static final Pattern MISSING = Pattern.compile("Missing required creator property '([^']+)'");

    private LessonJson() {}

    /** Reads a record from a text. */
    public static <T> Reading<T> read(String file, String text, Class<T> type) {
        try {
            return new Reading<>(Optional.of(MAPPER.readValue(text, type)), List.of());
        } catch (JsonProcessingException e) {
            return refused(file, text, e);
        }
    }

    /** Reads a list of records from a text. */
    public static <T> Reading<List<T>> readList(String file, String text, Class<T> type) {
        try {
            return new Reading<>(
                    Optional.of(
                            MAPPER.readValue(text, MAPPER.getTypeFactory().constructCollectionType(List.class, type))),
                    List.of());
        } catch (JsonProcessingException e) {
            return refused(file, text, e);
        }
    }

    /** Reads a record from a tree. */
    public static <T> Reading<T> read(JsonNode tree, TypeReference<T> type) {
        try {
            return new Reading<>(Optional.of(MAPPER.readValue(MAPPER.treeAsTokens(tree), type)), List.of());
        } catch (java.io.IOException e) {
            return e instanceof JsonProcessingException wrong
                    ? new Reading<>(Optional.empty(), List.of(finding(wrong)))
                    : new Reading<>(Optional.empty(), List.of(Finding.error(CODE, "", String.valueOf(e.getMessage()))));
        }
    }

    /** The JSON of a record, in lines. */
    public static String write(Object any) {
        try {
            return MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(any) + "\n";
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("a record of the course cannot be written", e);
        }
    }

    private static <T> Reading<T> refused(String file, String text, JsonProcessingException e) {
        Reading<T> reading = new Reading<>(Optional.empty(), List.of(finding(e)));
        return reading.locatedIn(file, text);
    }

    private static Finding finding(JsonProcessingException e) {
        boolean isJson = !(e instanceof StreamReadException || e.getCause() instanceof StreamReadException);
        String pointer = isJson && e instanceof JsonMappingException mapping
                ? mapping.getPath().stream().map(LessonJson::step).collect(Collectors.joining())
                : "";
        Finding finding = Finding.error(CODE, pointer, words(e));
        return !pointer.isEmpty()
                        || e.getLocation() == null
                        || e.getLocation().getLineNr() < 1
                        || e.getLocation().getColumnNr() < 1
                ? finding
                : finding.at(new SourceLocation(
                        "", e.getLocation().getLineNr(), e.getLocation().getColumnNr()));
    }

    private static String step(JsonMappingException.Reference reference) {
        return "/" + (reference.getFieldName() == null ? "" + reference.getIndex() : reference.getFieldName());
    }

    private static String words(JsonProcessingException e) {
        if (e instanceof UnrecognizedPropertyException unknown) {
            return "\"" + unknown.getPropertyName() + "\" is no member here; known are "
                    + unknown.getKnownPropertyIds().stream()
                            .map(String::valueOf)
                            .sorted()
                            .collect(Collectors.joining(", "));
        }
        Throwable cause = e.getCause();
        if (cause instanceof IllegalArgumentException wrong && wrong.getMessage() != null) {
            return wrong.getMessage();
        }
        String message = e.getOriginalMessage();
        Matcher missing = MISSING.matcher(String.valueOf(message));
        if (missing.find()) {
            return "\"" + missing.group(1) + "\" is missing";
        }
        return message == null ? "cannot be read" : message.lines().findFirst().orElse("cannot be read");
    }
}
