package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.ImportOrigin;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Reads project documents (docs/file-format.md). Every problem becomes a finding with its JSON pointer; with an error
 * nothing is loaded. What is well formed but makes no sense as a plan, such as two start places, is left to
 * {@code spn.analysis}: an author may save it and go on, only not start it.
 */
public final class ProjectReader {
    /** The version of the format that is read and written. */
    public static final int FORMAT_VERSION = 1;

    /** The member by which a file names its JSON Schema, for editors; it is kept as it stands. */
    static final String SCHEMA = "$schema";

    private final Vocabulary vocabulary;

    /** A reader of projects of one domain; has no state of its own. */
    public ProjectReader(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /** Reads a file, or a folder that holds {@code project.json} and the plan files that it names. */
    public Reading<Project> read(Path path) {
        return readAndCheck(path, ProjectReader::unchecked);
    }

    /** Reads one document; it may not name other files. */
    public Reading<Project> read(String text) {
        return read("", text, name -> Optional.empty(), ProjectReader::unchecked);
    }

    /**
     * Reads a file or folder and checks its plans. Where there are findings and a result, the document can be shown and
     * edited; with an error no plan of it is to be started (thesis 5.1).
     */
    public Reading<Project> readAndCheck(Path path) {
        return readAndCheck(path, project -> PlanChecks.check(project, vocabulary));
    }

    /** Reads one document and checks its plans. */
    public Reading<Project> readAndCheck(String text) {
        return read("", text, name -> Optional.empty(), project -> PlanChecks.check(project, vocabulary));
    }

    /**
     * Reads a file or folder and makes checks of what was read; their findings get their places in the files as the reader's do.
     *
     * @param checks what a program finds in a project that could be read
     */
    public Reading<Project> readAndCheck(Path path, Function<Project, List<Finding>> checks) {
        Path file = Files.isDirectory(path) ? path.resolve("project.json") : path;
        Problems problems = new Problems();
        DomainSources.Source sibling = name -> TextFiles.read(file.resolveSibling(name));
        Optional<String> text = fetch(file, problems);
        return text.map(t -> read(file.toString(), t, sibling, checks)).orElseGet(() -> Reading.nothing(problems));
    }

    private static List<Finding> unchecked(Project project) {
        return List.of();
    }

    private Reading<Project> read(
            String file, String text, DomainSources.Source sibling, Function<Project, List<Finding>> checks) {
        Problems problems = new Problems();
        SourceTexts sources = new SourceTexts();
        sources.add("", file, text);
        Optional<Project> project = JsonText.parse(text, problems)
                .flatMap(node -> JsonObjectReader.of(node, "", problems))
                .filter(root -> checkVersion(root, problems))
                .map(root -> readProject(root, new PlanFiles(file, sibling, sources), problems));
        if (!problems.none()) {
            project.ifPresent(p -> problems.addAll(PlanChecks.checkUnloaded(p, vocabulary), ""));
            return new Reading<>(Optional.empty(), sources.locate(problems.findings()));
        }
        List<Finding> findings = new ArrayList<>(problems.findings());
        project.ifPresent(p -> findings.addAll(checks.apply(p)));
        return new Reading<>(project, sources.locate(findings));
    }

    private Optional<String> fetch(Path file, Problems problems) {
        try {
            Optional<String> text = TextFiles.read(file);
            if (text.isEmpty()) {
                problems.add(Codes.FILE, "", "There is no file " + file);
            }
            return text;
        } catch (FileTooLargeException e) {
            problems.add(Codes.FILE, "", "The file " + e.getMessage());
            return Optional.empty();
        } catch (IOException e) {
            problems.add(
                    Codes.FILE, "", "The file " + file + " cannot be read: it is not UTF-8 text or not accessible");
            return Optional.empty();
        }
    }

    /** An unknown version is the only finding about its document: nothing else in it can be judged. */
    private static boolean checkVersion(JsonObjectReader root, Problems problems) {
        Optional<JsonNode> version = root.node("formatVersion");
        if (version.isEmpty()) {
            problems.add(Codes.VERSION, "", "\"formatVersion\" is missing: this is not a SAMI project");
        } else if (!version.get().isIntegralNumber()) {
            problems.add(Codes.VERSION, "/formatVersion", "The format's version is a whole number");
        } else if (version.get().longValue() != FORMAT_VERSION) {
            String which = version.get().longValue() > FORMAT_VERSION
                    ? "was written by a newer program (format version "
                    : "has an unknown format (version ";
            problems.add(
                    Codes.VERSION,
                    "/formatVersion",
                    "This file " + which + version.get().asText() + "); this program reads version " + FORMAT_VERSION);
        }
        return problems.none();
    }

    private Project readProject(JsonObjectReader root, PlanFiles files, Problems problems) {
        Optional<String> schema = root.has(SCHEMA) ? Optional.of(root.text(SCHEMA, "")) : Optional.empty();
        String id = root.text("id");
        String name = root.text("name", "");
        String domain = root.text("domain");
        if (!domain.isEmpty() && !domain.equals(vocabulary.domain())) {
            root.problem(
                    Codes.DOMAIN,
                    "domain",
                    "The project is of the domain " + domain + "; loaded is " + vocabulary.domain());
        }
        PlanParts parts = new PlanParts(vocabulary, problems);
        List<VariableSpec> globals = parts.variables(root, "globals");
        Map<String, JsonObjectReader> planMembers = files.plans(root, problems);
        Names planIds = new Names(problems);
        planMembers.forEach((where, m) -> {
            String planId = m.text("id", "");
            planIds.take(planId, m.at("id"));
            files.sources().planNamed(m.pointer(), planId);
        });
        List<Plan> plans = new ArrayList<>();
        planMembers.forEach((where, m) -> plans.add(new PlanReader(parts, m, globals, planIds).read()));
        List<MissionTreeNode> tree = root.objects("missionTree").stream()
                .map(m -> treeNode(m, planIds))
                .toList();
        Optional<ImportOrigin> origin = root.object("importedFrom").map(ProjectReader::origin);
        root.done();
        return new Project(id, name, domain, globals, tree, plans, schema, origin);
    }

    private static ImportOrigin origin(JsonObjectReader m) {
        List<ImportOrigin.Remark> remarks = new ArrayList<>();
        for (JsonObjectReader r : m.objects("remarks")) {
            remarks.add(new ImportOrigin.Remark(
                    r.text("code"), r.text("plan", ""), r.texts("elements"), r.text("message", "")));
            r.done();
        }
        ImportOrigin origin = new ImportOrigin(m.text("file"), remarks);
        m.done();
        return origin;
    }

    private static MissionTreeNode treeNode(JsonObjectReader m, Names planIds) {
        String label = m.text("label", "");
        Optional<String> plan = m.has("plan") ? Optional.of(m.text("plan")) : Optional.empty();
        plan.filter(p -> !p.isEmpty() && !planIds.has(p))
                .ifPresent(p ->
                        m.problem(Codes.UNKNOWN_PLAN, "plan", "There is no plan \"" + p + "\"" + planIds.meant(p)));
        List<MissionTreeNode> children =
                m.objects("children").stream().map(c -> treeNode(c, planIds)).toList();
        m.done();
        return new MissionTreeNode(label, plan, children);
    }
}
