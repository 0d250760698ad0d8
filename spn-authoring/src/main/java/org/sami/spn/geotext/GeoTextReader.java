package org.sami.spn.geotext;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/**
 * Reads the form: a line is {@code latitude,longitude} in degrees, {@code [}, {@code ]}, a comment that begins with
 * {@code #}, or blank. Differs from the earlier system's reader, which logs what it does not understand and goes on with
 * the rest: here such a file is not used.
 */
public final class GeoTextReader {
    private static final int DEEPEST = 2;

    private final List<LineFinding> findings = new ArrayList<>();
    private final List<GeoText.PointList> lists = new ArrayList<>();
    private List<GeoPoint> points = new ArrayList<>();
    private int depth;
    private int deepest;
    private int listLine;
    private boolean closed;

    private GeoTextReader() {}

    /** What was read, or nothing where there are errors; and all that was found. */
    public record Result(Optional<GeoText> text, List<LineFinding> findings) {
        public Result {
            findings = List.copyOf(findings);
        }
    }

    /** Reads a file's content. */
    public static Result read(byte[] content) {
        GeoTextReader reader = new GeoTextReader();
        Optional<String> text = reader.decoded(content);
        if (text.isPresent()) {
            List<String> lines = text.get().lines().toList();
            for (int i = 0; i < lines.size(); i++) {
                reader.line(i + 1, lines.get(i).strip());
            }
            reader.end(Math.max(1, lines.size()));
        }
        boolean bad = reader.findings.stream().anyMatch(LineFinding::isError);
        return new Result(
                bad ? Optional.empty() : Optional.of(new GeoText(reader.deepest, reader.lists)), reader.findings);
    }

    private Optional<String> decoded(byte[] content) {
        try {
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(content))
                    .toString();
            return text.indexOf('\0') < 0
                    ? Optional.of(text.startsWith("\uFEFF") ? text.substring(1) : text)
                    : noText();
        } catch (CharacterCodingException e) {
            return noText();
        }
    }

    private Optional<String> noText() {
        findings.add(LineFinding.error(1, "This is no text file"));
        return Optional.empty();
    }

    private void line(int number, String line) {
        if (line.isEmpty() || line.startsWith("#")) {
            return;
        }
        if (closed) {
            error(number, "The first list has ended; a file holds one");
        } else if (line.equals("[")) {
            open(number);
        } else if (line.equals("]")) {
            close(number);
        } else {
            point(number, line);
        }
    }

    private void open(int number) {
        if (depth == DEEPEST) {
            error(number, "Brackets are at most two deep");
            return;
        }
        if (!points.isEmpty()) {
            error(number, "A list holds points or lists, not both");
            return;
        }
        depth++;
        deepest = Math.max(deepest, depth);
        listLine = number;
    }

    private void close(int number) {
        if (depth == 0) {
            error(number, "There is no '[' that this ']' ends");
            return;
        }
        if (depth == deepest) {
            take(number);
        }
        depth--;
        closed = depth == 0;
    }

    private void take(int number) {
        if (points.isEmpty()) {
            error(number, "This list has no points");
        }
        lists.add(new GeoText.PointList(listLine, points));
        points = new ArrayList<>();
    }

    private void point(int number, String line) {
        if (depth < deepest) {
            error(number, "A list holds points or lists, not both");
            return;
        }
        if (points.isEmpty() && depth == 0) {
            listLine = number;
        }
        String[] parts = line.split(",", -1);
        if (parts.length != 2) {
            error(number, "Expected is latitude,longitude, '[' or ']', not '" + line + "'");
            return;
        }
        try {
            points.add(GeoPoint.of(Double.parseDouble(parts[0].strip()), Double.parseDouble(parts[1].strip())));
        } catch (NumberFormatException e) {
            error(number, "Expected is latitude,longitude in degrees, not '" + line + "'");
        } catch (IllegalArgumentException e) {
            error(number, String.valueOf(e.getMessage()));
        }
    }

    /** The outermost bracket may be missing at the end, as in files that the earlier system read. */
    private void end(int number) {
        if (depth > 0 && depth == deepest) {
            error(number, "The list that begins in line " + listLine + " has no ']'");
        } else if (depth > 0) {
            findings.add(LineFinding.warning(number, "The last ']' is missing; every list in it has its own"));
        } else if (deepest == 0 && !points.isEmpty()) {
            take(number);
        } else if (lists.isEmpty() && findings.isEmpty()) {
            error(number, "There is no point in this file");
        }
    }

    private void error(int line, String message) {
        findings.add(LineFinding.error(line, message));
    }
}
