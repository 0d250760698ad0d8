package org.sami.crw.cli.legacy;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.report.ReportWords;
import org.sami.crw.report.RunOutcome;
import org.sami.spn.finding.Finding;

/**
 * What came of the trial runs of a project.
 *
 * @param servers name of the simulated boat that stands for each server
 * @param trials one for each plan that was tried, in order
 * @param asked how many were to be tried
 */
public record TrialReport(Map<String, String> servers, List<PlanTrial> trials, int asked) {
    public TrialReport {
        servers = Collections.unmodifiableMap(new LinkedHashMap<>(servers));
        trials = List.copyOf(trials);
    }

    /** Whether all plans were tried, and nothing went wrong that is not the plans' own fault. */
    public boolean isSound() {
        return trials.size() == asked && trials.stream().allMatch(PlanTrial::isSound);
    }

    /** For people: what was found, the table, and where plans stand that still run. */
    public String text() {
        StringBuilder text = new StringBuilder();
        text.append('\n');
        for (PlanTrial trial : trials) {
            for (Finding finding : trial.findings()) {
                text.append(String.format(
                        Locale.ROOT,
                        "%s (%s): %s %s: %s%n",
                        trial.plan(),
                        trial.name(),
                        finding.severity().name().toLowerCase(Locale.ROOT),
                        finding.code(),
                        finding.message()));
            }
        }
        text.append('\n').append(table()).append('\n');
        for (PlanTrial trial : trials) {
            if (!trial.reason().isEmpty()) {
                text.append(trial.plan())
                        .append(" (")
                        .append(trial.name())
                        .append(") ")
                        .append(trial.outcome().word());
                text.append(": ").append(trial.reason()).append('\n');
            }
            for (Wait wait : trial.waitsFor()) {
                text.append(trial.plan()).append(" (").append(trial.name()).append(") ");
                text.append(words(wait, trial.plan())).append('\n');
            }
        }
        text.append(summary()).append('\n');
        return text.toString();
    }

    private String table() {
        int width = trials.stream().mapToInt(t -> t.name().length()).max().orElse(4);
        String form = "%-6s %-" + Math.max(4, width) + "s %-8s %12s %8s %10s %9s %9s%n";
        StringBuilder table = new StringBuilder(String.format(
                Locale.ROOT, form, "plan", "name", "outcome", "time", "firings", "decisions", "messages", "findings"));
        for (PlanTrial t : trials) {
            table.append(String.format(
                    Locale.ROOT,
                    form,
                    t.plan(),
                    t.name(),
                    t.outcome().word(),
                    ReportWords.duration(t.simulatedMillis()),
                    t.firings(),
                    t.decisions(),
                    t.messages(),
                    t.findings().size()));
        }
        return table.toString();
    }

    private static String words(Wait wait, String plan) {
        String where = wait.place().isEmpty() ? "" : "in '" + wait.place() + "'";
        String child = wait.plan().equals(plan)
                ? ""
                : wait.missions() == 1
                        ? " of its sub-mission " + wait.plan()
                        : " of " + wait.missions() + " sub-missions " + wait.plan();
        String who = wait.tokens().isEmpty() ? "" : " (" + String.join(", ", wait.tokens()) + ")";
        return "waits " + where + child + who + " for " + wait.occurrence();
    }

    private String summary() {
        if (trials.isEmpty()) {
            return "0 of " + asked + " plans tried";
        }
        List<String> parts = new ArrayList<>();
        for (RunOutcome outcome : RunOutcome.values()) {
            long n = trials.stream().filter(t -> t.outcome() == outcome).count();
            if (n > 0) {
                parts.add(n + " " + outcome.word());
            }
        }
        return trials.size() + " of " + asked + " plans tried: " + String.join(", ", parts) + "; "
                + (trials.stream().allMatch(PlanTrial::isSound)
                        ? "no engine error, no livelock, no event that nothing handles"
                        : trials.stream().filter(t -> !t.isSound()).count()
                                + " with an engine error, a livelock or an event that nothing handles");
    }

    /** For programs: one object a plan. */
    public ArrayNode plansJson() {
        ArrayNode plans = JsonNodeFactory.instance.arrayNode();
        for (PlanTrial trial : trials) {
            ObjectNode plan = plans.addObject();
            plan.put("id", trial.plan());
            plan.put("name", trial.name());
            plan.put("outcome", trial.outcome().word());
            plan.put("reason", trial.reason());
            plan.put("simulatedSeconds", trial.simulatedMillis() / 1000.0);
            plan.put("firings", trial.firings());
            plan.put("decisions", trial.decisions());
            plan.put("messages", trial.messages());
            ArrayNode waits = plan.putArray("waitsFor");
            trial.waitsFor().forEach(wait -> waits.add(json(wait)));
            ArrayNode findings = plan.putArray("findings");
            trial.findings().forEach(f -> findings.add(FindingJson.of(f)));
        }
        return plans;
    }

    private static ObjectNode json(Wait wait) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("missions", wait.missions());
        node.put("plan", wait.plan());
        node.put("place", wait.place());
        ArrayNode tokens = node.putArray("tokens");
        wait.tokens().forEach(tokens::add);
        node.put("occurrence", wait.occurrence());
        return node;
    }

    /** Which simulated boat stands for which server. */
    public ObjectNode serversJson() {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        servers.forEach(json::put);
        return json;
    }
}
