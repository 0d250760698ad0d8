package org.sami.crw.cli.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Stack;
import org.sami.crw.sim.experiment.table.ExperimentFileReader;
import org.sami.spn.json.BoundedFile;
import picocli.CommandLine.IParameterPreprocessor;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Recognises a call of {@code crw experiment} that is about a table or an experiment's file: such a call has other options, of which some have the same
 * names.
 */
final class TableArguments implements IParameterPreprocessor {
    private static final String TABLE = "--table";

    /** The command, for which a call about a table has other arguments. */
    interface Receiver {
        /** This call is about a table, with these arguments. */
        void makeTable(List<String> arguments);
    }

    @Override
    @SuppressWarnings("JdkObsolete") // picocli's interface has a Stack
    public boolean preprocess(Stack<String> args, CommandSpec spec, ArgSpec option, Map<String, Object> info) {
        if (args.stream().noneMatch(TableArguments::isOfATable)) {
            return false;
        }
        List<String> all = new ArrayList<>();
        while (!args.isEmpty()) {
            all.add(args.pop());
        }
        ((Receiver) spec.userObject()).makeTable(all);
        return true;
    }

    private static boolean isOfATable(String argument) {
        return argument.equals(TABLE) || argument.startsWith(TABLE + "=") || isExperiment(argument);
    }

    private static boolean isExperiment(String argument) {
        try {
            Path file = Path.of(argument);
            return argument.endsWith(".json")
                    && Files.isRegularFile(file)
                    && ExperimentFileReader.isExperiment(BoundedFile.text(file, BoundedFile.DATA_BYTES));
        } catch (InvalidPathException | IOException noFile) {
            return false; // whoever reads it as a project says what is wrong
        }
    }
}
