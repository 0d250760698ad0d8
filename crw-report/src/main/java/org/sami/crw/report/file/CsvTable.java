package org.sami.crw.report.file;

/** A table in the form of RFC 4180, with line feeds: what spreadsheets and statistics programs read. */
final class CsvTable {
    private final StringBuilder text = new StringBuilder();
    private final int columns;

    CsvTable(String... header) {
        columns = header.length;
        row((Object[]) header);
    }

    /** Adds a row; numbers are written with a point, text is quoted where it must be. */
    void row(Object... cells) {
        if (cells.length != columns) {
            throw new IllegalArgumentException("a row of " + cells.length + " cells in a table of " + columns);
        }
        text.append(CsvRow.of(cells));
    }

    /** A number with a fixed count of digits after the point. */
    static String fixed(double value, int digits) {
        return CsvRow.fixed(value, digits);
    }

    /** Milliseconds as seconds. */
    static String seconds(long millis) {
        return fixed(millis / 1000.0, 3);
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
