package org.sami.petri.pnml;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.xml.stream.XMLStreamException;
import org.sami.petri.net.PetriNet;

/**
 * Reads place/transition nets in PNML (ISO/IEC 15909-2). Pages and reference nodes are flattened; symmetric nets are unfolded; inhibitor, reset and read arcs are known by the {@code type} that
 * tools give to arcs. A file is read as a stream, so that what it holds decides about the memory and not its size.
 */
public final class PnmlReader {
    private PnmlReader() {}

    /**
     * Reads a file.
     *
     * @throws IOException if the file cannot be read; what is wrong in it is a finding
     */
    public static PnmlReading read(Path file, PnmlLimits limits) throws IOException {
        if (Files.isRegularFile(file) && Files.size(file) > limits.bytes()) {
            FindingList findings = new FindingList();
            findings.error(
                    "E-SIZE",
                    0,
                    "",
                    "the file has " + Files.size(file) + " bytes; at most " + limits.bytes() + " are read");
            return new PnmlReading(Optional.empty(), findings.all());
        }
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            return read(in, limits);
        }
    }

    /** Reads a stream, which stays open. */
    public static PnmlReading read(InputStream in, PnmlLimits limits) {
        FindingList findings = new FindingList();
        Optional<PetriNet> net = Optional.empty();
        try {
            PnmlParts parts = new PnmlParser(new XmlInput(in, limits), limits, findings).parse();
            if (parts.isColoured && !findings.hasErrors()) {
                parts = ColourUnfolding.unfold(parts, findings, limits);
            }
            PetriNet assembled = new PnmlAssembly(parts, findings).net();
            if (!findings.hasErrors()) {
                net = Optional.of(assembled);
            }
        } catch (RefusedPnmlException refused) {
            findings.error(refused.code(), refused.line(), "", refused.words());
        } catch (XMLStreamException broken) {
            findings.error("E-XML", lineOf(broken), "", words(broken));
        }
        return new PnmlReading(net, findings.all());
    }

    private static int lineOf(XMLStreamException broken) {
        return broken.getLocation() == null
                ? 0
                : Math.max(0, broken.getLocation().getLineNumber());
    }

    /** The message without the place that the parser puts before it. */
    private static String words(XMLStreamException broken) {
        if (broken.getNestedException() instanceof CharacterCodingException) {
            return "it is not written in UTF-8, as it says, or as it must be where it says nothing";
        }
        if (broken.getNestedException() instanceof IOException fault) {
            return String.valueOf(fault.getMessage());
        }
        String message = String.valueOf(broken.getMessage());
        int at = message.indexOf("Message: ");
        return "this is no well-formed XML: " + (at < 0 ? message : message.substring(at + "Message: ".length()));
    }
}
