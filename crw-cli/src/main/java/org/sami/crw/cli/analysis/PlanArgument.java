package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.model.ExampleNetNames;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;

/**
 * The plan that a command line names, with its net.
 *
 * @param plan what was named
 * @param net of it with its boats
 */
record PlanArgument(Plan plan, PlanNet net) {
    static final int MOST_BOATS = 25;

    /** Whether a name is that of a PNML file or an example net; a file of a plan ends in .json, or is a folder. */
    static boolean isNet(String name) {
        Path file = Path.of(name);
        return Files.exists(file)
                ? !Files.isDirectory(file) && !name.endsWith(".json")
                : ExampleNetNames.find(name).isPresent();
    }

    /**
     * Reads the plan and makes its net; empty where it has errors, which are printed then.
     *
     * @param depth how many levels of sub-missions its net follows
     * @param isNamed whether boats have names in the net; else they are counted where that can be
     * @throws UsageFault if there is no such plan, it has no start, or its net is too large
     */
    static Optional<PlanArgument> read(
            String name, DomainOption domain, String chosen, int boats, int depth, boolean isNamed, PrintWriter err) {
        if (boats < 0 || boats > MOST_BOATS) {
            throw new UsageFault("--boats is 0 to " + MOST_BOATS + ", not " + boats);
        }
        Reading<DomainLibrary> words = domain.read();
        if (words.result().isEmpty()) {
            FindingsText.print(err, domain.name(), words.findings());
            return Optional.empty();
        }
        DomainLibrary library = words.result().get();
        if (!Files.exists(Path.of(name)) && library.projectOf(name).isEmpty()) {
            throw new UsageFault("there is no file '" + name + "', no plan and no example net of that name; plans are "
                    + library.plans().stream().map(Plan::id).collect(Collectors.joining(", "))
                    + "; nets are " + String.join(", ", ExampleNetNames.words()));
        }
        PlanSource source = domain.find(name, library);
        Optional<Project> project = source.project();
        if (project.isEmpty()) {
            FindingsText.print(err, name, source.findings());
            return Optional.empty();
        }
        Plan plan = source.choose(chosen);
        List<Finding> findings = source.concerning(List.of(plan));
        if (findings.stream().anyMatch(Finding::isError)) {
            FindingsText.print(err, name, findings);
            return Optional.empty();
        }
        List<String> robots =
                IntStream.rangeClosed(1, boats).mapToObj(i -> "robot-" + i).toList();
        try {
            PlanNetRequest request =
                    new PlanNetRequest(project.get(), library.vocabulary(), plan.id(), robots).toDepth(depth);
            return Optional.of(new PlanArgument(plan, isNamed ? PlanNet.of(request) : PlanNet.smallest(request)));
        } catch (PlanNetTooLargeException | IllegalArgumentException refused) {
            throw new UsageFault(plan.id() + ": " + refused.getMessage());
        }
    }

    /** The plan with its team, such as {@code Station keep, 3 boats}. */
    String title() {
        int boats = net.request().robots().size();
        return plan.title() + ", " + (boats == 1 ? "1 boat" : boats + " boats");
    }
}
