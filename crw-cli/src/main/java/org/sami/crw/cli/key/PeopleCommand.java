package org.sami.crw.cli.key;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw people}: who may take part in a session that {@code crw serve} serves. */
@Command(
        name = "people",
        mixinStandardHelpOptions = true,
        synopsisSubcommandLabel = "COMMAND",
        description = "Lists, adds, changes and removes the people of sessions that 'crw serve' serves.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:done", "2:wrong usage, or a file that cannot be read"},
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw people add anna --role operator     prints anna's key, once",
            "  crw people add ben --role pilot --decisions OperatorApprove",
            "  crw people role ben operator            ben keeps the key, and is operator in running sessions within a"
                    + " second",
            "  crw people remove anna                  anna is out of running sessions within a second"
        })
public final class PeopleCommand implements Runnable {
    private static final String ROLES =
            "operator: everything; pilot: drives, presses interrupts, answers questions about"
                    + " boats; observer: watches. Everybody may stop the fleet.";
    private static final String TYPES =
            "Answers only decisions of these types, such as OperatorApprove (default: those of the role).";

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Override
    public void run() {
        throw new UsageFault("Which command? One of add, list, role, remove.");
    }

    @Command(
            name = "add",
            mixinStandardHelpOptions = true,
            description =
                    "Adds somebody and prints the key. It is stored as a hash only, so it cannot be printed again.")
    int add(
            @Mixin PeopleOption people,
            @Parameters(paramLabel = "NAME", description = "1 to 40 letters, digits, '-', '_' or '.'.") String name,
            @Option(names = "--role", paramLabel = "ROLE", required = true, description = ROLES) String role,
            @Option(names = "--decisions", paramLabel = "TYPE", split = ",", description = TYPES)
                    List<String> decisions)
            throws IOException {
        String key = PersonKey.generate();
        PersonRole is = role("--role", role);
        UsageFault.of(() -> {
            people.list().add(new Person(name, is, typesOf(decisions), PersonKey.hash(key)));
            return key;
        });
        print(name + " is " + is.word() + "; the key, six words, which are printed this once:");
        print(key);
        return ExitCode.OK;
    }

    @Command(name = "list", mixinStandardHelpOptions = true, description = "Lists everybody.")
    int list(@Mixin PeopleOption people) throws IOException {
        List<Person> all = people.list().all();
        if (all.isEmpty()) {
            print("nobody is listed in " + people.list().file());
        }
        for (Person person : all) {
            print(person.name() + "  " + rights(person.role(), person.decisions()));
        }
        return ExitCode.OK;
    }

    @Command(
            name = "role",
            mixinStandardHelpOptions = true,
            description =
                    "Gives somebody another role, also in running sessions, within a second. The key stays; decisions"
                            + " are those of the new role, or of --decisions.")
    int role(
            @Mixin PeopleOption people,
            @Parameters(index = "0", paramLabel = "NAME", description = "Who.") String name,
            @Parameters(index = "1", paramLabel = "ROLE", description = ROLES) String role,
            @Option(names = "--decisions", paramLabel = "TYPE", split = ",", description = TYPES)
                    List<String> decisions)
            throws IOException {
        PersonRole is = role("ROLE", role);
        Person before = UsageFault.of(() -> people.list().change(name, is, typesOf(decisions)));
        print(name + " is " + rights(is, typesOf(decisions)) + "; before: "
                + rights(before.role(), before.decisions()));
        return ExitCode.OK;
    }

    @Command(
            name = "remove",
            mixinStandardHelpOptions = true,
            description = "Removes people, who are out of running sessions within a second.")
    int remove(
            @Mixin PeopleOption people,
            @Parameters(paramLabel = "NAME", arity = "1..*", description = "Who.") List<String> names)
            throws IOException {
        for (String name : names) {
            UsageFault.of(() -> {
                people.list().remove(name);
                return name;
            });
            print(name + " is removed");
        }
        return ExitCode.OK;
    }

    private static PersonRole role(String where, String word) {
        return PersonRole.of(word)
                .orElseThrow(() -> new UsageFault(where + ": '" + word + "' is none of operator, pilot, observer"));
    }

    private static List<String> typesOf(@Nullable List<String> decisions) {
        return decisions == null ? List.of() : decisions;
    }

    /** A role, and the types of decisions where they are chosen. */
    private static String rights(PersonRole role, List<String> decisions) {
        List<String> words = new ArrayList<>(List.of(role.word()));
        words.addAll(decisions);
        return String.join("  ", words);
    }

    private void print(String line) {
        spec.commandLine().getOut().println(line);
        spec.commandLine().getOut().flush();
    }
}
