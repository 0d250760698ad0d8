package org.sami.crw.cli.option;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.handler.HandlerModules;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import picocli.CommandLine.Option;

/** The option {@code --domain}: the domain with whose vocabulary plans are read; boats by default. */
public final class DomainOption {
    private static final String SHIPPED = "/org/sami/domain/";

    @Option(
            names = "--domain",
            paramLabel = "NAME|FOLDER",
            defaultValue = "",
            description =
                    "The words of another domain: uav or team, which come with crw, or a folder with domain.json. "
                            + "Without it those of the boats.")
    private String domain = "";

    public boolean isGiven() {
        return !domain.isEmpty();
    }

    /** As it was given. */
    public String name() {
        return domain;
    }

    /**
     * Reads the domain.
     *
     * @throws UsageFault if there is no such folder and none of that name comes with the program
     */
    public Reading<DomainLibrary> read() {
        if (!isGiven()) {
            return new Reading<>(Optional.of(PlanSource.library()), List.of());
        }
        if (folder().isPresent()) {
            return fromFolder(folder().get());
        }
        if (!ships(domain)) {
            throw new UsageFault("--domain: there is no folder '" + domain + "', nor does such a domain come with crw");
        }
        return DomainLibrary.fromClassPath(SHIPPED + domain);
    }

    private static boolean ships(String name) {
        return name.matches("[a-z][a-z0-9-]*")
                && DomainOption.class.getResource(SHIPPED + name + "/domain.json") != null;
    }

    /**
     * A domain as it is now; empty where its folder is gone or its words have errors, or where none of that name comes with the program.
     *
     * @param name as its {@code domain.json} says
     * @param folder in which it is; empty for one that comes with the program
     */
    public static Optional<DomainLibrary> present(String name, Optional<Path> folder) {
        if (folder.isPresent()) {
            try {
                return fromFolder(folder.get()).result();
            } catch (UsageFault gone) {
                return Optional.empty();
            }
        }
        return ships(name) ? DomainLibrary.fromClassPath(SHIPPED + name).result() : Optional.empty();
    }

    /**
     * The domain for what runs its plans; empty where its words have errors, which are printed then.
     *
     * @throws UsageFault if there is no such domain, or nothing here does what its plans ask
     */
    public Optional<DomainLibrary> library(PrintWriter err) {
        Reading<DomainLibrary> reading = read();
        if (reading.hasErrors()) {
            FindingsText.print(err, domain, reading.findings());
            err.flush();
            return Optional.empty();
        }
        DomainLibrary library = reading.orThrow();
        if (!HandlerModules.isHandled(library.vocabulary())) {
            throw new UsageFault("--domain: nothing here does what the plans of "
                    + library.vocabulary().domain() + " ask; 'crw check' and 'crw test' take it");
        }
        return Optional.of(library);
    }

    private static Reading<DomainLibrary> fromFolder(Path folder) {
        try (Stream<Path> files = Files.walk(folder, 2)) {
            for (Path file : (Iterable<Path>) files.filter(one -> one.toString().endsWith(".json"))::iterator) {
                BoundedFile.check(file, BoundedFile.PROJECT_BYTES);
            }
            return BoundedFile.making(folder, () -> DomainLibrary.fromFolder(folder));
        } catch (IOException | UncheckedIOException fault) {
            throw new UsageFault("--domain: " + fault.getMessage());
        }
    }

    /**
     * Finds a plan, in a folder by the file in which it stands, so that findings name that file.
     *
     * @param plan a file, or the id of a plan of the domain's library
     * @throws UsageFault if there is no such plan and no such file
     */
    public PlanSource find(String plan, DomainLibrary library) {
        if (folder().isEmpty() || Files.exists(Path.of(plan))) {
            return PlanSource.find(plan, library);
        }
        Path folder = folder().get();
        return library.projects().entrySet().stream()
                .filter(file -> file.getValue().plan(plan).isPresent())
                .map(Map.Entry::getKey)
                .map(file -> PlanSource.find(folder.resolve(file).toString(), library, plan))
                .findFirst()
                .orElseGet(() -> PlanSource.find(plan, library));
    }

    /** All projects of the domain's library. */
    public List<PlanSource> all(DomainLibrary library) {
        return library.projects().entrySet().stream()
                .map(file -> folder().map(
                                folder -> folder.resolve(file.getKey()).toString())
                        .orElseGet(() -> file.getValue().plans().get(0).id()))
                .map(source -> PlanSource.find(source, library))
                .toList();
    }

    /** The folder in which the domain is; empty for one that comes with the program. */
    public Optional<Path> folder() {
        return Optional.of(domain).filter(d -> !d.isEmpty()).map(Path::of).filter(Files::isDirectory);
    }
}
