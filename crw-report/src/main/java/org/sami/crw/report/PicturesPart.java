package org.sami.crw.report;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * The pictures that boats took.
 *
 * @param pictures oldest first; at least one
 */
public record PicturesPart(List<PictureResult> pictures) implements ReportPart {
    public PicturesPart {
        pictures = List.copyOf(pictures);
    }

    /** A picture in the JSON object. */
    @JsonInclude(JsonInclude.Include.NON_EMPTY)
    private record Row(
            BigDecimal at,
            String boat,
            long mission,
            String name,
            BigDecimal latDeg,
            BigDecimal lonDeg,
            String file,
            String missed) {
        static Row of(PictureResult one) {
            return new Row(
                    BigDecimal.valueOf(one.atMillis(), 3).stripTrailingZeros(),
                    one.boat(),
                    one.mission(),
                    one.name(),
                    new BigDecimal(degrees(one.latDeg())).stripTrailingZeros(),
                    new BigDecimal(degrees(one.lonDeg())).stripTrailingZeros(),
                    one.file().isPresent() ? one.path() : "",
                    one.missed());
        }
    }

    @Override
    public String name() {
        return "pictures";
    }

    @Override
    public List<?> json() {
        return pictures.stream().map(Row::of).toList();
    }

    @Override
    public List<String> lines() {
        return pictures.stream()
                .collect(Collectors.groupingBy(PictureResult::boat, TreeMap::new, Collectors.toList()))
                .entrySet()
                .stream()
                .map(boat -> line(boat.getKey(), boat.getValue()))
                .toList();
    }

    private static String line(String boat, List<PictureResult> all) {
        long here = all.stream().filter(one -> one.file().isPresent()).count();
        String missed = all.stream()
                .map(PictureResult::missed)
                .filter(words -> !words.isEmpty())
                .findFirst()
                .map(words -> "; " + words)
                .orElse("");
        return String.format(Locale.ROOT, "%-11s pictures %d of %d%s", boat, here, all.size(), missed);
    }

    @Override
    public List<String> columns() {
        return List.of("at_s", "boat", "mission", "name", "lat_deg", "lon_deg", "file", "missed");
    }

    @Override
    public List<List<Object>> rows() {
        return pictures.stream()
                .map(one -> List.<Object>of(
                        String.format(Locale.ROOT, "%.3f", one.atMillis() / 1000.0),
                        one.boat(),
                        one.mission(),
                        one.name(),
                        degrees(one.latDeg()),
                        degrees(one.lonDeg()),
                        one.file().isPresent() ? one.path() : "",
                        one.missed()))
                .toList();
    }

    private static String degrees(double value) {
        return String.format(Locale.ROOT, "%.7f", value);
    }
}
