package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.ImportOrigin;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Writes projects: elements in the order of the model, members in one fixed order, defaults left out, laid out by
 * {@link CanonicalJson}. What it writes, {@link ProjectReader} reads back as an equal project; a file in that form is
 * written back byte for byte.
 */
public final class ProjectWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final Vocabulary vocabulary;

    /** A writer of projects of one domain. */
    public ProjectWriter(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /**
     * The project as one document.
     *
     * @throws IllegalArgumentException where the project speaks of events, fields or markups that the vocabulary lacks, or
     *     holds values that do not fit their type
     */
    public String text(Project project) {
        ObjectNode root = root(project);
        ArrayNode plans = root.putArray("plans");
        project.plans().forEach(p -> plans.add(planNode(project, p)));
        return CanonicalJson.print(root);
    }

    /**
     * Replaces a file by the project, or, where the path is a folder, the files in it: {@code project.json} and one file for
     * each plan. Each file is replaced by renaming; {@code project.json} is the last. Files of plans that are gone stay, and
     * are read no more.
     */
    public void write(Project project, Path path) throws IOException {
        if (!Files.isDirectory(path)) {
            AtomicFile.write(path, text(project));
            return;
        }
        ObjectNode root = root(project);
        ArrayNode files = root.putArray("plans");
        Set<String> taken = new HashSet<>();
        for (Plan plan : project.plans()) {
            String name = fileName(plan.id(), taken);
            files.addObject().put("file", name);
            Path file = path.resolve(name);
            AtomicFile.write(file, CanonicalJson.print(withSchemaOf(file, planNode(project, plan))));
        }
        AtomicFile.write(path.resolve("project.json"), CanonicalJson.print(root));
    }

    /** A plan does not hold the JSON Schema that its file names for editors: it is taken over from the file that is replaced. */
    private static ObjectNode withSchemaOf(Path file, ObjectNode plan) throws IOException {
        Optional<JsonNode> before = Files.exists(file)
                ? TextFiles.read(file).flatMap(text -> JsonText.parse(text, new Problems()))
                : Optional.empty();
        return before.map(node -> node.get(ProjectReader.SCHEMA))
                .filter(JsonNode::isTextual)
                .map(schema -> NODES.objectNode()
                        .<ObjectNode>set(ProjectReader.SCHEMA, schema)
                        .<ObjectNode>setAll(plan))
                .orElse(plan);
    }

    /** A name that is safe on every file system, also on those that do not tell capital letters from small ones. */
    private static String fileName(String planId, Set<String> taken) {
        String safe = URLEncoder.encode(planId, StandardCharsets.UTF_8).replace("*", "%2A");
        String name = "plans/" + safe + ".json";
        for (int i = 2; !taken.add(name.toLowerCase(Locale.ROOT)); i++) {
            name = "plans/" + safe + "~" + i + ".json";
        }
        return name;
    }

    private ObjectNode planNode(Project project, Plan plan) {
        return new PlanWriter(vocabulary, project).write(plan);
    }

    private ObjectNode root(Project project) {
        ObjectNode root = NODES.objectNode();
        project.schema().ifPresent(schema -> root.put(ProjectReader.SCHEMA, schema));
        root.put("formatVersion", ProjectReader.FORMAT_VERSION);
        root.put("id", project.id());
        OptionalMembers.putText(root, "name", project.name());
        root.put("domain", project.domain());
        if (!project.globals().isEmpty()) {
            root.set("globals", VariableWriter.write(project.globals(), vocabulary));
        }
        if (!project.missionTree().isEmpty()) {
            root.set("missionTree", tree(project.missionTree()));
        }
        project.importedFrom().ifPresent(origin -> root.set("importedFrom", origin(origin)));
        return root;
    }

    private static ObjectNode origin(ImportOrigin origin) {
        ObjectNode node = NODES.objectNode().put("file", origin.file());
        ArrayNode remarks = NODES.arrayNode();
        for (ImportOrigin.Remark r : origin.remarks()) {
            ObjectNode remark = remarks.addObject().put("code", r.code());
            OptionalMembers.putText(remark, "plan", r.plan());
            OptionalMembers.putTexts(remark, "elements", r.elements());
            OptionalMembers.putText(remark, "message", r.message());
        }
        if (!remarks.isEmpty()) {
            node.set("remarks", remarks);
        }
        return node;
    }

    private static ArrayNode tree(List<MissionTreeNode> nodes) {
        ArrayNode array = NODES.arrayNode();
        for (MissionTreeNode n : nodes) {
            ObjectNode node = array.addObject();
            OptionalMembers.putText(node, "label", n.label());
            n.plan().ifPresent(p -> node.put("plan", p));
            if (!n.children().isEmpty()) {
                node.set("children", tree(n.children()));
            }
        }
        return array;
    }
}
