package org.sami.crw.cli.analysis;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.model.ExampleNetNames;
import org.sami.petri.net.PetriNet;
import org.sami.petri.pnml.PnmlFinding;
import org.sami.petri.pnml.PnmlLimits;
import org.sami.petri.pnml.PnmlReader;
import org.sami.petri.pnml.PnmlReading;

/** The net that a command line names: a PNML file, or an example net such as {@code kanban-5}. */
final class NetArgument {
    private NetArgument() {}

    /** Reads the net. A name of an example net is one only where no file has this name. */
    static PnmlReading read(String name) throws IOException {
        Path file = Path.of(name);
        if (Files.exists(file) && !Files.isDirectory(file)) {
            return PnmlReader.read(file, PnmlLimits.STANDARD);
        }
        Optional<PetriNet> example = ExampleNetNames.find(name);
        if (example.isEmpty()) {
            throw new UsageFault("there is no file '" + name + "', and no example net of that name; these are "
                    + String.join(", ", ExampleNetNames.words()));
        }
        return new PnmlReading(example, List.of());
    }

    /** Prints findings as compilers do: file and line, severity, code, element, message. */
    static void print(PrintWriter out, String name, List<PnmlFinding> findings) {
        for (PnmlFinding finding : findings) {
            out.printf(
                    Locale.ROOT,
                    "%s%s: %s %s%s: %s%n",
                    name,
                    finding.line() > 0 ? ":" + finding.line() : "",
                    finding.severity().name().toLowerCase(Locale.ROOT),
                    finding.code(),
                    finding.element().isEmpty() ? "" : " at " + finding.element(),
                    finding.message());
        }
    }
}
