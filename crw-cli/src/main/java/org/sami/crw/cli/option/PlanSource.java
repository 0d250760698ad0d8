package org.sami.crw.cli.option;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.handler.HandledEvents;
import org.sami.crw.handler.HandlerModules;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A project that was named on the command line: a plan of the library by its id, or a file or folder by its path.
 *
 * @param source as it was named
 * @param plan the plan that the name itself chose; empty for files
 * @param findings all that reader and checks found
 */
public record PlanSource(String source, Optional<Project> project, Optional<Plan> plan, List<Finding> findings) {
    private static final String DOMAIN = "/org/sami/domain/crw";
    private static final String PROJECT_FILE = "project.json"; // in a folder

    public PlanSource {
        Objects.requireNonNull(source, "source");
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(plan, "plan");
        findings = List.copyOf(findings);
    }

    /** The domain that ships with the program. */
    public static DomainLibrary library() {
        return DomainLibrary.fromClassPath(DOMAIN).orThrow();
    }

    /**
     * Finds and reads it: a file, a folder of a project, or a plan of the library. A folder that has no project is none, where the library has such a plan.
     *
     * @throws UsageFault if there is no such plan and no such file
     */
    public static PlanSource find(String name, DomainLibrary library) {
        Path path = Path.of(name);
        boolean isOtherFolder = Files.isDirectory(path) && !Files.exists(path.resolve(PROJECT_FILE));
        boolean isOfLibrary = library.projectOf(name).isPresent();
        if (Files.exists(path) && !(isOtherFolder && isOfLibrary)) {
            Reading<Project> reading = read(path, library);
            return new PlanSource(name, reading.result(), Optional.empty(), reading.findings());
        }
        Optional<Project> project = library.projectOf(name);
        if (project.isEmpty()) {
            String kind = name.endsWith(".json") || name.contains("/") ? "file" : "file and no plan of the library";
            throw new UsageFault("there is no " + kind + " '" + name + "'; the library has " + ids(library.plans()));
        }
        return new PlanSource(name, project, project.get().plan(name), checked(library, project.get()));
    }

    private static Reading<Project> read(Path path, DomainLibrary library) {
        try {
            BoundedFile.check(Files.isDirectory(path) ? path.resolve(PROJECT_FILE) : path, BoundedFile.PROJECT_BYTES);
            return BoundedFile.making(
                    path,
                    () -> new ProjectReader(library.vocabulary()).readAndCheck(path, read -> checked(library, read)));
        } catch (IOException tooLarge) {
            throw new UsageFault(String.valueOf(tooLarge.getMessage()));
        }
    }

    /** All plans of a library, as one project. */
    public static PlanSource all(DomainLibrary library) {
        Project combined = library.combined();
        return new PlanSource("library", Optional.of(combined), Optional.empty(), checked(library, combined));
    }

    /** A plan that stands in a file, chosen by its id. */
    public static PlanSource find(String file, DomainLibrary library, String planId) {
        PlanSource all = find(file, library);
        return new PlanSource(file, all.project(), all.project().flatMap(p -> p.plan(planId)), all.findings());
    }

    /** What the checks of the language find and, in the domain whose handlers are here, what nothing would handle. */
    private static List<Finding> checked(DomainLibrary library, Project project) {
        Vocabulary vocabulary = library.vocabulary();
        List<Finding> all = new ArrayList<>(PlanChecks.check(project, vocabulary));
        if (HandlerModules.isHandled(vocabulary)) {
            all.addAll(PlanChecks.checkHandled(project, vocabulary, HandledEvents.of(vocabulary)));
        }
        return all;
    }

    public boolean hasErrors() {
        return findings.stream().anyMatch(Finding::isError);
    }

    /**
     * The plan to run.
     *
     * @param wanted id or name of a plan; empty text where the user named none
     * @throws UsageFault if there is none such, or several could be meant
     */
    public Plan choose(String wanted) {
        List<Plan> plans = project.map(Project::plans).orElse(List.of());
        if (!wanted.isEmpty()) {
            return plans.stream()
                    .filter(p -> p.id().equals(wanted) || p.name().equals(wanted))
                    .findFirst()
                    .orElseThrow(() -> new UsageFault(
                            "--plan: " + source + " has no plan '" + wanted + "'; it has " + ids(plans)));
        }
        if (plan.isPresent()) {
            return plan.get();
        }
        List<Plan> roots = roots(plans);
        if (roots.size() == 1) {
            return roots.get(0);
        }
        throw new UsageFault(source
                + (plans.isEmpty() ? " has no plan" : " has several plans; choose with --plan one of " + ids(plans)));
    }

    /** What was found about the project itself, the chosen plans and those that they run; another plan's faults do not keep them. */
    public List<Finding> concerning(List<Plan> chosen) {
        List<Plan> plans = project.map(Project::plans).orElse(List.of());
        Set<String> others = new LinkedHashSet<>();
        Set<String> family = new LinkedHashSet<>();
        chosen.forEach(plan -> collect(plans, plan.id(), family));
        for (int i = 0; i < plans.size(); i++) {
            if (!family.contains(plans.get(i).id())) {
                others.add("/plans/" + i);
            }
        }
        return findings.stream()
                .filter(f -> others.stream()
                        .noneMatch(o -> f.pointer().equals(o) || f.pointer().startsWith(o + "/")))
                .toList();
    }

    private static void collect(List<Plan> plans, String planId, Set<String> family) {
        if (family.add(planId)) {
            plans.stream()
                    .filter(p -> p.id().equals(planId))
                    .flatMap(p -> p.places().stream())
                    .flatMap(p -> p.subMissions().stream())
                    .forEach(s -> collect(plans, s.plan(), family));
        }
    }

    /** Plans that no other plan runs as a sub-mission. */
    private static List<Plan> roots(List<Plan> plans) {
        Set<String> children = new LinkedHashSet<>();
        for (Plan parent : plans) {
            for (Place place : parent.places()) {
                place.subMissions().stream().map(SubMissionSpec::plan).forEach(children::add);
            }
        }
        return plans.stream().filter(p -> !children.contains(p.id())).toList();
    }

    private static String ids(List<Plan> plans) {
        return plans.stream().map(Plan::id).collect(Collectors.joining(", "));
    }
}
