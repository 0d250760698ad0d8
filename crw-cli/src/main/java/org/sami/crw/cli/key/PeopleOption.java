package org.sami.crw.cli.key;

import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.session.person.People;
import org.sami.session.person.PeopleFile;
import picocli.CommandLine.Option;

/** Where the people of a session are listed. */
public final class PeopleOption {
    @Option(
            names = "--people",
            paramLabel = "FILE",
            description = "The list of people (default: ~/.config/sami/people).")
    private @Nullable Path file;

    /** The list, which need not exist. */
    PeopleFile list() {
        return new PeopleFile(file == null ? BaseProtection.folderOfThisUser().resolveSibling("people") : file);
    }

    /** Whoever may take part: the people of the list, or whoever is on this machine where there is no list. */
    public People people() {
        PeopleFile list = list();
        if (Files.exists(list.file())) {
            return list;
        }
        if (file != null) {
            throw new UsageFault("--people: there is no list " + file + "; 'crw people add' makes one");
        }
        return People.ofThisMachine();
    }
}
