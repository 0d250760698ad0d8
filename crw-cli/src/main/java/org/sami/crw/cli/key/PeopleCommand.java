package org.sami.crw.cli.key;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
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
        description = "Lists, adds and removes the people of sessions that 'crw serve' serves.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:done", "2:wrong usage, or a file that cannot be read"},
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw people add anna --role operator     prints anna's key, once",
            "  crw people add ben --role pilot --decisions OperatorApprove",
            "  crw people remove anna                  anna is out of running sessions within a second"
        })
public final class PeopleCommand implements Runnable {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Override
    public void run() {
        throw new UsageFault("Which command? One of add, list, remove.");
    }

    @Command(
            name = "add",
            mixinStandardHelpOptions = true,
            description =
                    "Adds somebody and prints the key. It is stored as a hash only, so it cannot be printed again.")
    int add(
            @Mixin PeopleOption people,
            @Parameters(paramLabel = "NAME", description = "1 to 40 letters, digits, '-', '_' or '.'.") String name,
            @Option(
                            names = "--role",
                            paramLabel = "ROLE",
                            required = true,
                            description =
                                    "operator: everything; pilot: drives, presses interrupts, answers questions about"
                                            + " boats; observer: watches. Everybody may stop the fleet.")
                    String role,
            @Option(
                            names = "--decisions",
                            paramLabel = "TYPE",
                            split = ",",
                            description =
                                    "Answers only decisions of these types, such as OperatorApprove (default: those of"
                                            + " the role).")
                    List<String> decisions)
            throws IOException {
        String key = PersonKey.generate();
        PersonRole is = PersonRole.of(role)
                .orElseThrow(() -> new UsageFault("--role: '" + role + "' is none of operator, pilot, observer"));
        UsageFault.of(() -> {
            people.list().add(new Person(name, is, decisions == null ? List.of() : decisions, PersonKey.hash(key)));
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
            List<String> words =
                    new ArrayList<>(List.of(person.name(), person.role().word()));
            words.addAll(person.decisions());
            print(String.join("  ", words));
        }
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

    private void print(String line) {
        spec.commandLine().getOut().println(line);
        spec.commandLine().getOut().flush();
    }
}
