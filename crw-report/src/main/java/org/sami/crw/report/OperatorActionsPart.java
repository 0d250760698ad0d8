package org.sami.crw.report;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * What the operator did.
 *
 * @param actions oldest first
 */
public record OperatorActionsPart(List<OperatorAction> actions) implements ReportPart {
    private static final int DEGREE_DIGITS = 7;

    public OperatorActionsPart {
        actions = List.copyOf(actions);
    }

    /** An action in the JSON object. */
    @JsonInclude(JsonInclude.Include.NON_NULL)
    private record Row(
            long number,
            BigDecimal at,
            String kind,
            String text,
            long mission,
            List<String> boats,
            @Nullable BigDecimal latDeg,
            @Nullable BigDecimal lonDeg) {
        static Row of(OperatorAction action) {
            return new Row(
                    action.number(),
                    BigDecimal.valueOf(action.atMillis(), 3).stripTrailingZeros(),
                    action.kind(),
                    action.text(),
                    action.mission(),
                    action.boats(),
                    decimal(action.latDeg()),
                    decimal(action.lonDeg()));
        }

        private static @Nullable BigDecimal decimal(Optional<Double> degrees) {
            return degrees.map(value -> BigDecimal.valueOf(value)
                            .setScale(DEGREE_DIGITS, RoundingMode.HALF_UP)
                            .stripTrailingZeros())
                    .orElse(null);
        }
    }

    @Override
    public String name() {
        return "operator";
    }

    @Override
    public List<?> json() {
        return actions.stream().map(Row::of).toList();
    }

    @Override
    public List<String> columns() {
        return List.of("number", "at_s", "kind", "text", "mission", "boats", "lat_deg", "lon_deg");
    }

    @Override
    public List<List<Object>> rows() {
        return actions.stream()
                .map(action -> List.<Object>of(
                        action.number(),
                        String.format(Locale.ROOT, "%.3f", action.atMillis() / 1000.0),
                        action.kind(),
                        action.text(),
                        action.mission(),
                        String.join(" ", action.boats()),
                        degrees(action.latDeg()),
                        degrees(action.lonDeg())))
                .toList();
    }

    private static String degrees(Optional<Double> value) {
        return value.map(deg -> String.format(Locale.ROOT, "%.7f", deg)).orElse("");
    }
}
