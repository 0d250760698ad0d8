package org.sami.crw.report.statistics;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.sami.crw.report.ReportWords;
import org.sami.crw.report.file.CsvRow;

/** Statistics of sessions as text, as CSV and as JSON. */
public final class StatisticsFormats {
    private static final String NONE = "-";

    private StatisticsFormats() {}

    /** Text for people, with line feeds. */
    public static String text(SessionFigures sessions) {
        List<List<String>> lines = new ArrayList<>();
        lines.add(List.of(
                "plan",
                "# run",
                "total",
                "mean",
                "least",
                "most",
                "decisions",
                "clicks",
                "answer",
                "boats",
                "distance",
                "interrupts"));
        PlanStatistics.of(sessions.missions()).forEach(plan -> lines.add(line(plan)));
        StringBuilder text = new StringBuilder();
        for (List<String> line : lines) {
            text.append(padded(line, lines).stripTrailing()).append('\n');
        }
        long running = sessions.missions().stream().filter(one -> !one.isOver()).count();
        text.append(String.format(
                Locale.ROOT,
                "%n%d journals, %s: %d missions started, %d of them by other missions, %d not over%n"
                        + "%d decisions, %d clicks, %.1f clicks a minute%n",
                sessions.journals(),
                ReportWords.duration(sessions.millis()),
                sessions.missions().size(),
                sessions.missions().stream().filter(one -> !one.isRoot()).count(),
                running,
                sessions.decisions(),
                sessions.clicks(),
                sessions.clicksPerMinute()));
        return text.toString().replace(System.lineSeparator(), "\n");
    }

    private static List<String> line(PlanStatistics plan) {
        return List.of(
                plan.plan(),
                String.valueOf(plan.runs()),
                ReportWords.duration(plan.totalMillis()),
                ReportWords.duration(plan.meanMillis()),
                ReportWords.duration(plan.leastMillis()),
                ReportWords.duration(plan.mostMillis()),
                String.valueOf(plan.decisions()),
                String.valueOf(plan.clicks()),
                plan.meanAnswerMillis().isEmpty()
                        ? NONE
                        : ReportWords.duration(
                                Math.round(plan.meanAnswerMillis().getAsDouble())),
                String.valueOf(plan.boats()),
                plan.distanceM().isEmpty() ? NONE : Math.round(plan.distanceM().getAsDouble()) + " m",
                plan.presses().isEmpty() ? NONE : presses(plan));
    }

    /** Names to the left, numbers to the right. */
    private static String padded(List<String> line, List<List<String>> lines) {
        StringBuilder padded = new StringBuilder();
        int last = line.size() - 1;
        for (int column = 0; column <= last; column++) {
            int index = column;
            int width = lines.stream()
                    .mapToInt(other -> other.get(index).length())
                    .max()
                    .orElse(0);
            String gap = " ".repeat(width - line.get(column).length());
            boolean isName = column == 0 || column == last;
            padded.append(column == 0 ? "" : "  ").append(isName ? line.get(column) + gap : gap + line.get(column));
        }
        return padded.toString();
    }

    private static String presses(PlanStatistics plan) {
        return plan.presses().entrySet().stream()
                .map(press -> press.getKey() + " " + press.getValue())
                .collect(Collectors.joining("; "));
    }

    /** A row for each plan; RFC 4180. */
    public static String csv(SessionFigures sessions) {
        StringBuilder text = new StringBuilder(CsvRow.of(
                "plan",
                "runs",
                "not_over",
                "total_s",
                "mean_s",
                "least_s",
                "most_s",
                "decisions",
                "answered",
                "mean_answer_s",
                "clicks",
                "boats",
                "distance_m",
                "interrupts"));
        for (PlanStatistics plan : PlanStatistics.of(sessions.missions())) {
            text.append(CsvRow.of(
                    plan.plan(),
                    plan.runs(),
                    plan.running(),
                    seconds(plan.totalMillis()),
                    seconds(plan.meanMillis()),
                    seconds(plan.leastMillis()),
                    seconds(plan.mostMillis()),
                    plan.decisions(),
                    plan.answered(),
                    plan.meanAnswerMillis().isEmpty()
                            ? ""
                            : seconds(Math.round(plan.meanAnswerMillis().getAsDouble())),
                    plan.clicks(),
                    plan.boats(),
                    number(plan.distanceM()),
                    presses(plan)));
        }
        return text.toString();
    }

    private static String seconds(long millis) {
        return CsvRow.fixed(millis / 1000.0, 3);
    }

    private static String number(OptionalDouble value) {
        return value.isEmpty() ? "" : CsvRow.fixed(value.getAsDouble(), 1);
    }

    /** One object: the sessions together, and their plans. */
    public static ObjectNode json(SessionFigures sessions) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        object.put("journals", sessions.journals());
        object.put("seconds", sessions.millis() / 1000.0);
        object.put("decisions", sessions.decisions());
        object.put("clicks", sessions.clicks());
        object.put("clicksPerMinute", Math.round(sessions.clicksPerMinute() * 1000) / 1000.0);
        ArrayNode plans = object.putArray("plans");
        PlanStatistics.of(sessions.missions()).forEach(plan -> plans.add(node(plan)));
        return object;
    }

    private static ObjectNode node(PlanStatistics plan) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("plan", plan.plan());
        node.put("runs", plan.runs());
        node.put("notOver", plan.running());
        node.put("totalSeconds", plan.totalMillis() / 1000.0);
        node.put("meanSeconds", plan.meanMillis() / 1000.0);
        node.put("leastSeconds", plan.leastMillis() / 1000.0);
        node.put("mostSeconds", plan.mostMillis() / 1000.0);
        node.put("decisions", plan.decisions());
        node.put("answered", plan.answered());
        plan.meanAnswerMillis().ifPresent(mean -> node.put("meanAnswerSeconds", Math.round(mean) / 1000.0));
        node.put("clicks", plan.clicks());
        node.put("boats", plan.boats());
        plan.distanceM().ifPresent(metres -> node.put("distanceM", Math.round(metres * 10) / 10.0));
        ObjectNode interrupts = node.putObject("interrupts");
        plan.presses().forEach(interrupts::put);
        return node;
    }
}
