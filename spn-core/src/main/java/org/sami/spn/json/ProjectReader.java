package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
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

    private final Vocabulary vocabulary;

    /** A reader of projects of one domain; has no state of its own. */
    public ProjectReader(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /** Reads a file, or a folder that holds {@code project.json} and the plan files that it names. */
    public Reading<Project> read(Path path) {
        Path file = Files.isDirectory(path) ? path.resolve("project.json") : path;
        Problems problems = new Problems();
        VocabularyFiles.Source beside = name -> VocabularyFiles.Texts.read(file.resolveSibling(name));
        Optional<String> text = fetch(file, problems);
        return text.map(t -> read(t, beside)).orElseGet(() -> Reading.nothing(problems));
    }

    /** Reads one document; it may not name other files. */
    public Reading<Project> read(String text) {
        return read(text, name -> Optional.empty());
    }

    /**
     * Reads a file or folder and checks its plans. Where there are findings and a result, the document can be shown and
     * edited; with an error no plan of it is to be started (thesis 5.1).
     */
    public Reading<Project> readAndCheck(Path path) {
        return checked(read(path));
    }

    /** Reads one document and checks its plans. */
    public Reading<Project> readAndCheck(String text) {
        return checked(read(text));
    }

    private Reading<Project> checked(Reading<Project> reading) {
        if (reading.result().isEmpty()) {
            return reading;
        }
        List<Finding> findings = new ArrayList<>(reading.findings());
        findings.addAll(PlanChecks.check(reading.result().get(), vocabulary));
        return new Reading<>(reading.result(), findings);
    }

    Reading<Project> read(String text, VocabularyFiles.Source beside) {
        Problems problems = new Problems();
        Optional<Members> root = JsonText.parse(text, problems).flatMap(node -> Members.of(node, "", problems));
        if (root.isEmpty() || !checkVersion(root.get(), problems)) {
            return Reading.nothing(problems);
        }
        Project project = readProject(root.get(), beside, problems);
        if (!problems.none()) {
            problems.addAll(PlanChecks.checkUnloaded(project, vocabulary), "");
        }
        return Reading.of(project, problems);
    }

    private Optional<String> fetch(Path file, Problems problems) {
        try {
            Optional<String> text = VocabularyFiles.Texts.read(file);
            if (text.isEmpty()) {
                problems.add(Codes.FILE, "", "There is no file " + file);
            }
            return text;
        } catch (IOException e) {
            problems.add(
                    Codes.FILE, "", "The file " + file + " cannot be read: it is not UTF-8 text or not accessible");
            return Optional.empty();
        }
    }

    /** An unknown version is the only finding about its document: nothing else in it can be judged. */
    private static boolean checkVersion(Members root, Problems problems) {
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

    private Project readProject(Members root, VocabularyFiles.Source beside, Problems problems) {
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
        Map<String, Members> planMembers = planMembers(root, beside, problems);
        Names planIds = new Names(problems);
        planMembers.forEach((where, m) -> planIds.take(m.text("id", ""), m.at("id")));
        List<Plan> plans = new ArrayList<>();
        planMembers.forEach((where, m) -> plans.add(new PlanReader(parts, m, globals, planIds).read()));
        List<MissionTreeNode> tree = root.objects("missionTree").stream()
                .map(m -> treeNode(m, planIds))
                .toList();
        root.done();
        return new Project(id, name, domain, globals, tree, plans);
    }

    /** The plans' objects by pointer; those in files of their own have pointers that begin with the file's name. */
    private static Map<String, Members> planMembers(Members root, VocabularyFiles.Source beside, Problems problems) {
        Map<String, Members> plans = new LinkedHashMap<>();
        for (Members m : root.objects("plans")) {
            if (!m.has("file")) {
                plans.put(m.pointer(), m);
                continue;
            }
            String name = m.text("file");
            m.done();
            if (name.contains("..") || name.startsWith("/") || name.contains("\\") || name.contains(":")) {
                m.problem(Codes.FILE, "file", "A plan's file lies in the project's folder, not at " + name);
                continue;
            }
            Problems inFile = new Problems();
            VocabularyFiles.fetch(beside, name, inFile)
                    .flatMap(text -> JsonText.parse(text, inFile))
                    .flatMap(node -> Members.of(node, name + "#", problems))
                    .ifPresent(members -> plans.put(name, members));
            problems.addAll(inFile.findings(), "");
        }
        return plans;
    }

    private static MissionTreeNode treeNode(Members m, Names planIds) {
        String label = m.text("label", "");
        Optional<String> plan = m.has("plan") ? Optional.of(m.text("plan")) : Optional.empty();
        plan.filter(p -> !p.isEmpty() && !planIds.has(p))
                .ifPresent(p -> m.problem(Codes.UNKNOWN_PLAN, "plan", "There is no plan \"" + p + "\"", p));
        List<MissionTreeNode> children =
                m.objects("children").stream().map(c -> treeNode(c, planIds)).toList();
        m.done();
        return new MissionTreeNode(label, plan, children);
    }
}
