package org.sami.crw.cli.legacy;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.legacy.CountedKind;
import org.sami.spn.legacy.LegacyImport;

/**
 * What an import brought.
 *
 * @param source the export as it was named
 * @param target where the project was written
 * @param trials of its plans; empty where none were requested
 */
public record ImportReport(String source, String target, LegacyImport.Result result, Optional<TrialReport> trials) {
    public ImportReport {
        Objects.requireNonNull(source, "source");
        Objects.requireNonNull(target, "target");
        Objects.requireNonNull(result, "result");
        Objects.requireNonNull(trials, "trials");
    }

    /** For people: what was found, those of one code together, a table of the counts, and whether all arrived. */
    public String text() {
        StringBuilder text = new StringBuilder(FindingGroups.text(result.findings(), this::planOf));
        if (result.project().isEmpty()) {
            return text.append(source)
                    .append(": ")
                    .append(count(Severity.ERROR))
                    .append(" errors; nothing is imported\n")
                    .toString();
        }
        text.append(String.format(Locale.ROOT, "%-22s %8s %8s %10s%n", "", "source", "imported", "explained"));
        for (CountedKind kind : CountedKind.values()) {
            text.append(String.format(
                    Locale.ROOT,
                    "%-22s %8d %8d %10d%n",
                    kind.label(),
                    result.source().of(kind),
                    result.imported().of(kind),
                    result.explained().of(kind)));
        }
        text.append(verdict())
                .append("; ")
                .append(count(Severity.WARNING))
                .append(" warnings, ")
                .append(count(Severity.NOTE))
                .append(" notes\n");
        text.append("written to ").append(target).append('\n');
        return text.toString();
    }

    private String verdict() {
        if (result.isComplete()) {
            return "complete: all arrived, less what is explained by findings";
        }
        if (!result.isAccountedFor()) {
            return "NOT COMPLETE: the numbers do not add up, and no finding says why";
        }
        Map<String, Long> lost = result.losses().stream()
                .collect(Collectors.groupingBy(Finding::code, TreeMap::new, Collectors.counting()));
        return "NOT COMPLETE: " + result.losses().size() + " things of the export say less here ("
                + lost.entrySet().stream()
                        .map(e -> e.getKey() + " " + e.getValue())
                        .collect(Collectors.joining(", "))
                + ")";
    }

    /** The name of the plan that a finding is about; empty text for the project itself. */
    private String planOf(Finding finding) {
        return result.planOf(finding);
    }

    /** The same with trials of its plans. */
    public ImportReport with(TrialReport tried) {
        return new ImportReport(source, target, result, Optional.of(tried));
    }

    /** Which simulated boats stand for which servers, for people. */
    public static String servers(Map<String, String> boatOfServer) {
        StringBuilder text = new StringBuilder("each server is a simulated boat on loopback in this process:\n");
        boatOfServer.forEach((server, boat) -> text.append(String.format(Locale.ROOT, "  %-22s %s%n", server, boat)));
        return text.toString();
    }

    private long count(Severity severity) {
        return result.findings().stream().filter(f -> f.severity() == severity).count();
    }

    /** For programs. */
    public ObjectNode json() {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        json.put("source", source);
        json.put("target", result.project().isPresent() ? target : "");
        json.put("complete", result.isComplete());
        json.put("lost", result.losses().size());
        ObjectNode counts = json.putObject("counts");
        ObjectNode exported = counts.putObject("source");
        result.source().byLabel().forEach(exported::put);
        ObjectNode imported = counts.putObject("imported");
        result.imported().byLabel().forEach(imported::put);
        ObjectNode explained = counts.putObject("explained");
        result.explained().byLabel().forEach(explained::put);
        ArrayNode findings = json.putArray("findings");
        result.findings().forEach(f -> findings.add(FindingJson.of(f)));
        trials.ifPresent(tried -> {
            json.set("servers", tried.serversJson());
            json.put("sound", tried.isSound());
            json.set("plans", tried.plansJson());
        });
        return json;
    }
}
