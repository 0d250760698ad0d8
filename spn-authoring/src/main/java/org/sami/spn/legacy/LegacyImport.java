package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.FileTooLargeException;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.ImportOrigin;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Imports projects of the earlier system. With an error in the export nothing is imported; what arrives otherwise than it
 * stood there, or not at all, is a warning or a note that says so.
 */
public final class LegacyImport {
    private final Vocabulary vocabulary;
    private final LegacyTable table;

    /**
     * What came of an import.
     *
     * @param project empty where the export has errors
     * @param source counts of the export
     * @param imported counts of the project, without what was written although the export does not have it
     * @param explained what of the export's counts is not in the project, because a finding says why
     * @param roots ids of the plans that are started by themselves and have a start place, in order
     * @param planNames names of the export's plans, in its order
     */
    public record Result(
            Optional<Project> project,
            List<Finding> findings,
            Counts source,
            Counts imported,
            Counts explained,
            List<String> roots,
            List<String> planNames) {
        public Result {
            Objects.requireNonNull(project, "project");
            findings = List.copyOf(findings);
            roots = List.copyOf(roots);
            planNames = List.copyOf(planNames);
        }

        /** The name of the plan that a finding is about; empty text where it is about none. */
        public String planOf(Finding finding) {
            return LegacyPlan.indexIn(finding.pointer())
                    .filter(i -> i < planNames.size())
                    .map(planNames::get)
                    .orElse("");
        }

        /** Whether the counts agree: a finding explains everything that is not in the project. */
        public boolean isAccountedFor() {
            return imported.plus(explained).equals(source);
        }

        /** Findings that name what says less here than it did in the export: its meaning was lost, or is kept as text only. */
        public List<Finding> losses() {
            return findings.stream()
                    .filter(f -> LegacyCodes.LOSSES.contains(f.code()))
                    .toList();
        }

        /** Whether all that the export says arrived. */
        public boolean isComplete() {
            return project.isPresent() && isAccountedFor() && losses().isEmpty();
        }
    }

    /** An import into one domain; has no state of its own. */
    public LegacyImport(Vocabulary vocabulary, LegacyTable table) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.table = Objects.requireNonNull(table, "table");
    }

    /** Whether a remark of an import says that something arrived otherwise than it stood there, or not at all. */
    public static boolean isChange(ImportOrigin.Remark remark) {
        return LegacyCodes.isChange(remark.code());
    }

    /** Imports a file. */
    public Result read(Path file) {
        try {
            return read(
                    StandardCharsets.UTF_8
                            .newDecoder()
                            .decode(java.nio.ByteBuffer.wrap(BoundedFile.bytes(file, BoundedFile.PROJECT_BYTES)))
                            .toString(),
                    name(file),
                    String.valueOf(file.getFileName()));
        } catch (CharacterCodingException e) {
            return failed(LegacyCodes.FILE, "The file " + file + " is not UTF-8 text");
        } catch (FileTooLargeException e) {
            return failed(LegacyCodes.FILE, "The file " + e.getMessage());
        } catch (IOException e) {
            return failed(LegacyCodes.FILE, "The file " + file + " cannot be read");
        }
    }

    private static String name(Path file) {
        String name = String.valueOf(file.getFileName());
        return name.endsWith(".json") ? name.substring(0, name.length() - 5) : name;
    }

    private static Result failed(String code, String message) {
        return nothing(List.of(Finding.error(code, "", message)), new Counts(java.util.Map.of()));
    }

    private static Result nothing(List<Finding> findings, Counts source) {
        Counts none = new Counts(java.util.Map.of());
        return new Result(Optional.empty(), findings, source, none, none, List.of(), List.of());
    }

    /**
     * Imports a document.
     *
     * @param name the project's name here
     */
    public Result read(String text, String name) {
        return read(text, name, name);
    }

    private Result read(String text, String name, String fileName) {
        Findings findings = new Findings();
        LegacyReader reader = new LegacyReader(findings);
        Optional<JsonNode> document = reader.parse(text);
        Optional<LegacyProject> read = document.flatMap(reader::read);
        Counts source = document.map(Counts::of).orElse(new Counts(java.util.Map.of()));
        if (read.isEmpty() || findings.hasErrors()) {
            return nothing(findings.list(), source);
        }
        return convert(read.get(), name, fileName, source, findings);
    }

    private Result convert(LegacyProject read, String name, String fileName, Counts source, Findings findings) {
        Counts.Tally explained = new Counts.Tally();
        Counts.Tally added = new Counts.Tally();
        Copies copies = new Copies(read, findings, explained);
        LegacyValues values = new LegacyValues(vocabulary, table, copies);
        EventConverter events = new EventConverter(
                vocabulary,
                table,
                values,
                new MarkupConverter(vocabulary, table, values, findings, explained),
                findings,
                explained);
        PlanConverter converter = new PlanConverter(
                vocabulary,
                table,
                copies,
                events,
                new RequirementConverter(findings, explained, added),
                findings,
                explained);
        List<Plan> plans = read.plans().stream()
                .filter(p -> copies.of(p.id()).isEmpty())
                .map(converter::convert)
                .toList();
        VariableDeclarations variables =
                new VariableDeclarations(vocabulary, values, events.units(), read, plans, findings);
        List<Plan> declared = plans.stream().map(variables::declare).toList();
        Project project = new Project(
                name.isBlank() ? "imported" : name,
                name,
                vocabulary.domain(),
                variables.globals(),
                read.tree().map(t -> List.of(node(t, copies))).orElse(List.of()),
                declared,
                Optional.empty(),
                Optional.of(new ImportOrigin(fileName, remarks(read, declared, findings))));
        List<String> roots = read.plans().stream()
                .filter(p -> p.role() == LegacyPlan.Role.ROOT && p.hasStart())
                .map(LegacyPlan::id)
                .toList();
        refuseWhatCannotBeReadBack(project, findings);
        if (findings.hasErrors()) {
            return nothing(findings.list(), source);
        }
        Counts written = Counts.of(project).minus(added.counts());
        List<String> names = read.plans().stream()
                .map(p -> p.name().isBlank() ? p.id() : p.name())
                .toList();
        return new Result(Optional.of(project), findings.list(), source, written, explained.counts(), roots, names);
    }

    /** The findings so far, of plans that are in the project; their pointers lead into the export and are not kept. */
    private static List<ImportOrigin.Remark> remarks(LegacyProject read, List<Plan> plans, Findings findings) {
        Set<String> here = plans.stream().map(Plan::id).collect(Collectors.toSet());
        return findings.list().stream()
                .map(f -> new ImportOrigin.Remark(
                        f.code(),
                        LegacyPlan.indexIn(f.pointer())
                                .map(i -> read.plans().get(i).id())
                                .filter(here::contains)
                                .orElse(""),
                        f.elements(),
                        f.message()))
                .toList();
    }

    /** What the earlier system's format holds and this one cannot: nobody gets a file that is then refused. */
    private void refuseWhatCannotBeReadBack(Project project, Findings findings) {
        Reading<Project> again = new ProjectReader(vocabulary).read(new ProjectWriter(vocabulary).text(project));
        if (again.result().isEmpty()) {
            again.findings().stream()
                    .filter(Finding::isError)
                    .forEach(f -> findings.error(
                            LegacyCodes.UNREADABLE,
                            "",
                            "The project that came of it is none: at " + f.pointer() + " of it, " + f.message(),
                            f.elements().toArray(String[]::new)));
        } else if (!again.result().get().equals(project)) {
            findings.error(
                    LegacyCodes.UNREADABLE, "", "The project that came of it would be read otherwise than written");
        }
    }

    private static MissionTreeNode node(LegacyProject.TreeNode node, Copies copies) {
        List<MissionTreeNode> children = node.children().stream()
                .filter(c -> c.plan().flatMap(copies::of).isEmpty())
                .map(c -> node(c, copies))
                .toList();
        return new MissionTreeNode(node.label(), node.plan(), children);
    }
}
