package org.sami.crw.cli;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.FileTooLargeException;
import picocli.CommandLine;
import picocli.CommandLine.IDefaultValueProvider;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * Options that a person sets once, in a file of properties: {@code run.speed = max} for one command, {@code seed = 7} for all that have
 * the option. The command line comes before the file.
 */
final class Configuration implements IDefaultValueProvider {
    private static final String OPTION = "--config";
    private static final String DASHES = "--";

    private final Map<String, String> values = new LinkedHashMap<>();

    private Configuration() {}

    /**
     * Reads the file that {@code --config} names, or else the person's own where there is one.
     *
     * @param line whose options the file may set
     * @param environment of the process: HOME and XDG_CONFIG_HOME say where a person's own file is
     * @throws UsageFault if it is not there, cannot be read, or names what is no option
     */
    static Configuration read(CommandLine line, Map<String, String> environment, String... args) {
        Optional<Path> named = named(args);
        Optional<Path> file = named.or(() -> own(environment).filter(Files::isRegularFile));
        Configuration configuration = new Configuration();
        file.ifPresent(path -> configuration.load(line, path));
        return configuration;
    }

    private static Optional<Path> named(String... args) {
        for (int i = 0; i < args.length; i++) {
            if (args[i].startsWith(OPTION + "=")) {
                return Optional.of(Path.of(args[i].substring(OPTION.length() + 1)));
            } else if (args[i].equals(OPTION) && i + 1 < args.length) {
                return Optional.of(Path.of(args[i + 1]));
            }
        }
        return Optional.empty();
    }

    private static Optional<Path> own(Map<String, String> environment) {
        String base = environment.getOrDefault("XDG_CONFIG_HOME", "");
        String home = environment.getOrDefault("HOME", "");
        if (!base.isEmpty()) {
            return Optional.of(Path.of(base, "sami", "crw.properties"));
        }
        return home.isEmpty() ? Optional.empty() : Optional.of(Path.of(home, ".config", "sami", "crw.properties"));
    }

    private void load(CommandLine line, Path file) {
        Properties properties = new Properties();
        try {
            properties.load(new StringReader(BoundedFile.text(file, BoundedFile.SETTINGS_BYTES)));
        } catch (FileTooLargeException e) {
            throw new UsageFault(OPTION + ": " + e.getMessage());
        } catch (IOException | IllegalArgumentException e) {
            throw new UsageFault(OPTION + ": " + file + " cannot be read"
                    + (Files.exists(file) ? "; it is to be lines of NAME = VALUE in UTF-8" : ": it is not there"));
        }
        for (String key : new TreeSet<>(properties.stringPropertyNames())) {
            if (!isOption(line, key)) {
                throw new UsageFault(
                        file + ": '" + key + "' is no option; what can be set is COMMAND.OPTION or OPTION, "
                                + "such as run.speed or seed ('crw help COMMAND' lists them)");
            }
            values.put(key, properties.getProperty(key).strip());
        }
    }

    private static boolean isOption(CommandLine line, String key) {
        int dot = key.indexOf('.');
        if (dot < 0) {
            return has(line, key) || line.getSubcommands().values().stream().anyMatch(command -> has(command, key));
        }
        CommandLine command = line.getSubcommands().get(key.substring(0, dot));
        return command != null && has(command, key.substring(dot + 1));
    }

    private static boolean has(CommandLine command, String name) {
        OptionSpec option = command.getCommandSpec().findOption(DASHES + name);
        return option != null && !option.usageHelp() && !option.versionHelp();
    }

    @Override
    public @Nullable String defaultValue(ArgSpec argument) {
        if (!(argument instanceof OptionSpec option)) {
            return null;
        }
        for (String name : option.names()) {
            String key = name.startsWith(DASHES) ? name.substring(DASHES.length()) : name;
            String own = values.get(argument.command().name() + "." + key);
            String value = own == null ? values.get(key) : own;
            if (value != null) {
                return value;
            }
        }
        return null;
    }
}
