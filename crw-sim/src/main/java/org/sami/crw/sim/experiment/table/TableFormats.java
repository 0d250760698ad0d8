package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.sami.crw.report.file.CsvRow;
import org.sami.crw.sim.experiment.statistics.StudentTest;

/** An experiment's table as text, as CSV and as HTML. */
public final class TableFormats {
    private TableFormats() {}

    /** Text for people, with line feeds. */
    public static String text(ResultTable table) {
        List<List<String>> lines = new ArrayList<>();
        lines.add(table.header());
        table.lines().forEach(line -> lines.add(table.texts(line)));
        StringBuilder text = new StringBuilder(table.file().title()).append("\n\n");
        for (List<String> line : lines) {
            StringBuilder padded = new StringBuilder();
            for (int column = 0; column < line.size(); column++) {
                int index = column;
                int width = lines.stream()
                        .mapToInt(other -> other.get(index).length())
                        .max()
                        .orElse(0);
                String cell = line.get(column);
                String gap = " ".repeat(width - cell.length());
                padded.append(column == 0 ? cell + gap : "  " + gap + cell);
            }
            text.append(padded.toString().stripTrailing()).append('\n');
        }
        text.append('\n');
        table.notes().forEach(note -> text.append(note).append('\n'));
        return text.toString();
    }

    /** A row for each cell, with both probabilities; RFC 4180. */
    public static String csv(ResultTable table) {
        StringBuilder text = new StringBuilder(CsvRow.of(
                "configuration",
                "column",
                "measure",
                "kind",
                "of",
                "against",
                "n",
                "mean",
                "standard_error",
                "p_two_sample",
                "p_paired",
                "published",
                "failed",
                "redrawn"));
        for (ResultTable.Line line : table.lines()) {
            for (TableCell cell : line.cells()) {
                TableColumn column = cell.column();
                text.append(CsvRow.of(
                        line.configuration().key(),
                        column.title(),
                        column.measure().word(),
                        column.kind().name().toLowerCase(Locale.ROOT),
                        column.of(),
                        column.against(),
                        cell.values().size(),
                        number(cell.values().mean()),
                        number(cell.values().standardError()),
                        number(cell.twoSample().map(StudentTest::p)),
                        number(cell.paired().map(StudentTest::p)),
                        line.published().getOrDefault(column.published(), ""),
                        line.failed(),
                        line.redrawn()));
            }
        }
        return text.toString();
    }

    private static String number(OptionalDouble value) {
        return value.isEmpty() ? "" : CsvRow.fixed(value.getAsDouble(), 4);
    }

    private static String number(Optional<Double> value) {
        return value.map(known -> CsvRow.fixed(known, 6)).orElse("");
    }

    /** A page of its own. */
    public static String html(ResultTable table) {
        String rows =
                table.lines().stream().map(line -> row("td", table.texts(line))).collect(Collectors.joining());
        String notes = table.notes().stream()
                .map(note -> "<p>" + escaped(note) + "</p>\n")
                .collect(Collectors.joining());
        return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>"
                + escaped(table.file().title())
                + "</title>\n"
                + "<style>body{font-family:sans-serif}table{border-collapse:collapse}th,td{border-bottom:1px solid"
                + " #999;padding:4px"
                + " 10px;text-align:right}th:first-child,td:first-child{text-align:left}p{max-width:60em}</style></head>\n"
                + "<body><h1>"
                + escaped(table.file().title()) + "</h1>\n<table>\n" + row("th", table.header()) + rows
                + "</table>\n" + notes + "</body></html>\n";
    }

    private static String row(String element, List<String> cells) {
        return cells.stream()
                .map(cell -> "<" + element + ">" + escaped(cell) + "</" + element + ">")
                .collect(Collectors.joining("", "<tr>", "</tr>\n"));
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
