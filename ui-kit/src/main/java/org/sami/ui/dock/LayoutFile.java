package org.sami.ui.dock;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Looks at a file of an arrangement before Modern Docking reads it, whose parser would fetch what a document type names and write out what
 * entities stand for: a file with a document type is none that this program wrote.
 */
final class LayoutFile {
    private static final long MOST_BYTES = 1 << 20;
    private static final int MOST_SET_ASIDE = 9;

    private LayoutFile() {}

    /** Why the file must not be read; empty if it may be, or is not there. */
    static Optional<String> fault(Path file) {
        try {
            if (!Files.exists(file)) {
                return Optional.empty();
            }
            if (Files.size(file) > MOST_BYTES) {
                return Optional.of("it has more than " + MOST_BYTES + " bytes");
            }
            try (InputStream in = Files.newInputStream(file)) {
                return hasDocumentType(in) ? Optional.of("it has a document type") : Optional.empty();
            }
        } catch (IOException | XMLStreamException unreadable) {
            return Optional.of("it is no XML: " + unreadable.getMessage());
        }
    }

    /** Keeps a file that is not used under a name that none has yet; gives that. */
    static Path setAside(Path file) throws IOException {
        for (int i = 1; ; i++) {
            Path aside = file.resolveSibling(file.getFileName() + ".damaged" + (i == 1 ? "" : "-" + i));
            if (i == MOST_SET_ASIDE) {
                return Files.move(file, aside, StandardCopyOption.REPLACE_EXISTING);
            } else if (!Files.exists(aside)) {
                return Files.move(file, aside);
            }
        }
    }

    private static boolean hasDocumentType(InputStream in) throws XMLStreamException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false);
        factory.setXMLResolver((publicId, systemId, base, namespace) -> InputStream.nullInputStream());
        XMLStreamReader reader = factory.createXMLStreamReader(in);
        try {
            while (reader.hasNext()) {
                int event = reader.next();
                if (event == XMLStreamConstants.DTD || event == XMLStreamConstants.ENTITY_REFERENCE) {
                    return true;
                }
            }
            return false;
        } finally {
            reader.close();
        }
    }
}
