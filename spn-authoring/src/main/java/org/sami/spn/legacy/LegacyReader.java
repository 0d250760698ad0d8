package org.sami.spn.legacy;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.json.JsonObjectReader;

/**
 * Reads the neutral export of the earlier system's projects into a {@link LegacyProject}. Every problem is a finding with its
 * JSON pointer; with an error there is no project.
 */
final class LegacyReader {
    static final String FORMAT = "sami-legacy-project";
    static final int VERSION = 1;

    private static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    private final Findings findings;

    LegacyReader(Findings findings) {
        this.findings = findings;
    }

    /** The document as a tree; empty, with an error, where it is no JSON. */
    Optional<JsonNode> parse(String text) {
        try {
            JsonNode node = MAPPER.readTree(text);
            if (node == null || node.isMissingNode()) {
                findings.error(LegacyCodes.SYNTAX, "", "The document is empty");
                return Optional.empty();
            }
            return Optional.of(node);
        } catch (JsonProcessingException e) {
            JsonLocation at = e.getLocation();
            String place = at == null ? "" : "Line " + at.getLineNr() + ", column " + at.getColumnNr() + ": ";
            String message = e.getOriginalMessage() == null
                    ? "not JSON"
                    : e.getOriginalMessage().lines().findFirst().orElse("not JSON");
            findings.error(LegacyCodes.SYNTAX, "", place + message);
            return Optional.empty();
        }
    }

    /** The project; what it holds is complete only where the findings have no error. */
    Optional<LegacyProject> read(JsonNode document) {
        Optional<JsonObjectReader> root =
                JsonObjectReader.of(document, "", findings).filter(this::isOfThisFormat);
        return root.map(this::project);
    }

    /** A document of another format or version gets one finding that names it, and no other. */
    private boolean isOfThisFormat(JsonObjectReader root) {
        String format = root.text("format", "");
        if (!format.equals(FORMAT)) {
            root.problem(
                    LegacyCodes.FORMAT,
                    format.isEmpty() ? "" : "format",
                    "This is no export of the earlier system: \"format\" is "
                            + (format.isEmpty() ? "missing" : "\"" + format + "\"") + ", not \"" + FORMAT + "\"");
            return false;
        }
        int version = root.integer("version", 0);
        if (version != VERSION) {
            root.problem(
                    LegacyCodes.VERSION,
                    root.node("version").isPresent() ? "version" : "",
                    root.node("version").isEmpty()
                            ? "\"version\" is missing; this program reads version " + VERSION
                            : "The export has version " + root.node("version").get() + "; this program reads version "
                                    + VERSION);
            return false;
        }
        return true;
    }

    private LegacyProject project(JsonObjectReader root) {
        String source = root.object("source").map(s -> s.text("file", "")).orElse("");
        root.skip("source", "project");
        List<LegacyProject.Global> globals =
                root.objects("globalVariables").stream().map(this::global).toList();
        Set<String> names = new HashSet<>();
        for (LegacyProject.Global g : globals) {
            unique(names, g.name(), JsonObjectReader.at(g.pointer(), "name"), "The global variable " + g.name());
        }
        if (root.node("plans").isEmpty()) {
            root.problem(LegacyCodes.MISSING, "", "The member \"plans\" is missing");
        }
        LegacyPlanReader planReader = new LegacyPlanReader(findings);
        List<LegacyPlan> plans =
                root.objects("plans").stream().map(planReader::plan).toList();
        Set<String> ids = new HashSet<>();
        for (LegacyPlan plan : plans) {
            unique(ids, plan.id(), JsonObjectReader.at(plan.pointer(), "id"), "The plan id " + plan.id());
        }
        plans.forEach(plan -> checkReferences(plan, ids));
        new SubMissionCycles(plans).findings().forEach(findings::add);
        Optional<LegacyProject.TreeNode> tree = root.object("missionTree").map(t -> node(t, ids));
        List<String> notes = root.texts("notes");
        root.done();
        return new LegacyProject(source, globals, tree, plans, notes);
    }

    private void unique(Set<String> taken, String id, String pointer, String what) {
        if (!id.isEmpty() && !taken.add(id)) {
            findings.error(LegacyCodes.DUPLICATE, pointer, what + " is there twice", id);
        }
    }

    private LegacyProject.Global global(JsonObjectReader g) {
        LegacyProject.Global global = new LegacyProject.Global(
                g.pointer(),
                LegacyPlanReader.variable(g, "name", g.text("name")),
                g.text("class", ""),
                g.node("value").map(n -> new LegacyValue(g.at("value"), n)));
        g.done();
        return global;
    }

    private LegacyProject.TreeNode node(JsonObjectReader n, Set<String> planIds) {
        Optional<String> plan = n.node("plan").isPresent() ? Optional.of(n.text("plan")) : Optional.empty();
        plan.filter(p -> !p.isEmpty() && !planIds.contains(p))
                .ifPresent(p -> n.problem(LegacyCodes.DANGLING, "plan", "There is no plan \"" + p + "\"", p));
        List<LegacyProject.TreeNode> children = new ArrayList<>();
        n.objects("children").forEach(c -> children.add(node(c, planIds)));
        LegacyProject.TreeNode node = new LegacyProject.TreeNode(n.text("label", ""), plan, children);
        n.skip("name").done();
        return node;
    }

    private void checkReferences(LegacyPlan plan, Set<String> planIds) {
        for (LegacyPlan.Vertex v : plan.vertices()) {
            for (LegacyPlan.SubMission s : v.subMissions()) {
                if (!s.plan().isEmpty() && !planIds.contains(s.plan())) {
                    findings.error(
                            LegacyCodes.DANGLING,
                            JsonObjectReader.at(s.pointer(), "plan"),
                            "There is no plan \"" + s.plan() + "\" for the place " + v.title() + " to run",
                            v.key());
                }
            }
        }
    }
}
