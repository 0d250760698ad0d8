package org.sami.spn.json;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.spn.component.ComponentLibrary;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A domain as it ships: its vocabulary and its library of plans. Each file of the library is a project of its own, so that
 * it can also be opened, checked and run alone.
 *
 * @param files the vocabulary's files as text, for the journal
 * @param components what windows show and ask values with; none where the domain names no file of them
 * @param authoring what helps to write plans; nothing where the domain names no file of it
 * @param projects the projects of the library, by the name of their file, in the order of the domain's index
 */
public record DomainLibrary(
        Vocabulary vocabulary,
        VocabularyFiles files,
        ComponentLibrary components,
        AuthoringLibrary authoring,
        Map<String, Project> projects) {
    private static final Map<String, Reading<DomainLibrary>> OF_CLASS_PATH = new ConcurrentHashMap<>();

    public DomainLibrary {
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(files, "files");
        Objects.requireNonNull(components, "components");
        Objects.requireNonNull(authoring, "authoring");
        projects = Collections.unmodifiableMap(new LinkedHashMap<>(projects));
    }

    /**
     * Loads a domain from the class path, which does not change while the process lives: what was loaded once is given again.
     *
     * @param folder absolute, such as {@code /org/sami/domain/NAME}
     */
    public static Reading<DomainLibrary> fromClassPath(String folder) {
        Reading<DomainLibrary> known = OF_CLASS_PATH.get(folder);
        if (known != null) {
            return known;
        }
        Reading<DomainLibrary> loaded =
                load(VocabularyFiles.fromClassPath(folder), folder, DomainSources.ofClassPath(folder));
        if (loaded.result().isPresent()) {
            OF_CLASS_PATH.put(folder, loaded);
        }
        return loaded;
    }

    /** Loads a domain from a folder. */
    public static Reading<DomainLibrary> fromFolder(Path folder) {
        return load(VocabularyFiles.fromFolder(folder), folder.toString(), DomainSources.ofFolder(folder));
    }

    private static Reading<DomainLibrary> load(Reading<VocabularyFiles> files, String folder, DomainSources source) {
        Problems problems = new Problems();
        SourceTexts texts = new SourceTexts();
        Optional<DomainLibrary> library = load(files, folder, source, texts, problems);
        return new Reading<>(problems.none() ? library : Optional.empty(), texts.locate(problems.findings()));
    }

    private static Optional<DomainLibrary> load(
            Reading<VocabularyFiles> files, String folder, DomainSources source, SourceTexts texts, Problems problems) {
        problems.addAll(files.findings(), "");
        Optional<Vocabulary> vocabulary = files.result().flatMap(f -> {
            f.texts().forEach((name, text) -> texts.add(name + "#", folder + "/" + name, text));
            Reading<Vocabulary> reading = VocabularyReader.read(f);
            problems.addAll(reading.findings(), "");
            return reading.result();
        });
        return vocabulary.map(v -> {
            VocabularyFiles found = files.orThrow();
            DomainSources.Source located = name -> {
                Optional<String> text = source.with(found.combines()).text(name);
                text.ifPresent(t -> texts.add(name + "#", folder + "/" + name, t));
                return text;
            };
            return new DomainLibrary(
                    v,
                    found,
                    readPart(found, VocabularyFiles.COMPONENTS, t -> ComponentReader.read(t, v), located, problems)
                            .reduce(ComponentLibrary::and)
                            .orElse(ComponentLibrary.EMPTY),
                    readPart(found, VocabularyFiles.AUTHORING, t -> AuthoringReader.read(t, v), located, problems)
                            .reduce(AuthoringLibrary::and)
                            .orElse(AuthoringLibrary.EMPTY),
                    readProjects(found, v, located, problems));
        });
    }

    /** Reads the files that a member of the index names, and of the indexes of combined domains. */
    private static <T> Stream<T> readPart(
            VocabularyFiles files,
            String member,
            Function<String, Reading<T>> reader,
            DomainSources.Source source,
            Problems problems) {
        return files.named(member).stream()
                .flatMap(name -> VocabularyFiles.fetch(source, name, problems)
                        .flatMap(text -> {
                            Reading<T> reading = reader.apply(text);
                            problems.addAll(reading.findings(), name + "#");
                            return reading.result();
                        })
                        .stream());
    }

    private static Map<String, Project> readProjects(
            VocabularyFiles files, Vocabulary vocabulary, DomainSources.Source source, Problems problems) {
        ProjectReader reader = new ProjectReader(vocabulary);
        Map<String, Project> projects = new LinkedHashMap<>();
        Names planIds = new Names(problems);
        Names globals = new Names(problems);
        for (String name : files.library()) {
            Optional<String> text = VocabularyFiles.fetch(source, name, problems);
            Optional<Project> project = text.flatMap(t -> {
                Reading<Project> reading = reader.read(t);
                problems.addAll(reading.findings(), name + "#");
                return reading.result();
            });
            project.ifPresent(p -> {
                projects.put(name, p);
                p.plans().forEach(plan -> planIds.take(plan.id(), name));
                p.globals().forEach(g -> globals.take(g.name(), name));
            });
        }
        return projects;
    }

    /** All plans of the library, in order. */
    public List<Plan> plans() {
        return projects.values().stream().flatMap(p -> p.plans().stream()).toList();
    }

    /** The project in which a plan stands. */
    public Optional<Project> projectOf(String planId) {
        return projects.values().stream()
                .filter(p -> p.plan(planId).isPresent())
                .findFirst();
    }

    /** One project with all plans and globals of the library, for a session that may start any of them. */
    public Project combined() {
        List<Plan> plans = plans();
        List<VariableSpec> globals = new ArrayList<>();
        List<MissionTreeNode> tree = new ArrayList<>();
        projects.values().forEach(p -> {
            globals.addAll(p.globals());
            tree.addAll(p.missionTree());
        });
        String domain = vocabulary.domain();
        return new Project(domain + "-library", "Library of " + domain, domain, globals, tree, plans);
    }
}
