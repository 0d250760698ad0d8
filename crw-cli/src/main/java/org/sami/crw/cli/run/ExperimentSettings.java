package org.sami.crw.cli.run;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.sami.crw.cli.output.Version;
import org.sami.crw.sim.experiment.ExperimentCase;
import org.sami.crw.sim.experiment.table.ExperimentFile;
import org.sami.crw.sim.run.settings.SettingsMap;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;

/** All that the results of an experiment depend on, as text by name: two machines divide its runs only where all of it is equal. Long texts stand there as their SHA-256. */
final class ExperimentSettings {
    private static final int LONGEST = 80;

    private ExperimentSettings() {}

    /** Of missions with seeds in conditions. */
    static Map<String, String> of(
            List<ExperimentCase> cases, List<String> conditions, List<Long> seeds, DomainLibrary library) {
        Map<String, String> settings = common(library);
        settings.put("missions", cases.stream().map(ExperimentCase::label).collect(Collectors.joining(",")));
        settings.put("conditions", String.join(",", conditions));
        settings.put("seeds", words(seeds));
        for (ExperimentCase one : cases) {
            String of = one.label() + " ";
            settings.put(of + "plan's content", sha256(project(one.plan().project(), library)));
            SettingsMap.write(one.settings()).forEach((name, value) -> settings.put(of + name, value));
        }
        settings.replaceAll((name, value) -> brief(value));
        return settings;
    }

    /** Of a table. */
    static Map<String, String> of(
            ExperimentFile file, int repetitions, long seed, DomainLibrary library, Project project) {
        Map<String, String> settings = common(library);
        settings.put("plans' content", sha256(project(project, library)));
        settings.put("repetitions", String.valueOf(repetitions));
        settings.put("seed", String.valueOf(seed));
        file.settings().forEach(settings::put);
        file.factors().forEach((name, values) -> settings.put(name, String.join(",", values)));
        settings.put(
                "configurations",
                file.configurations().stream()
                        .map(ExperimentFile.Configuration::key)
                        .collect(Collectors.joining(";")));
        settings.put("derived values", file.derived().toString());
        settings.put("undisturbed version", file.undisturbed());
        settings.put("scripts", sha256(file.scripts().toString()));
        settings.replaceAll((name, value) -> brief(value));
        return settings;
    }

    private static Map<String, String> common(DomainLibrary library) {
        Map<String, String> settings = new TreeMap<>();
        settings.put("program's version", Version.ofThisProgram());
        settings.put("domain's content", sha256(new TreeMap<>(library.files().texts()).toString()));
        return settings;
    }

    private static String project(Project project, DomainLibrary library) {
        return new ProjectWriter(library.vocabulary()).text(project);
    }

    private static String words(List<Long> seeds) {
        long first = seeds.get(0);
        List<Long> following =
                LongStream.range(first, first + seeds.size()).boxed().toList();
        return seeds.size() > 1 && seeds.equals(following)
                ? first + ".." + (first + seeds.size() - 1)
                : seeds.stream().map(String::valueOf).collect(Collectors.joining(","));
    }

    private static String brief(String value) {
        return value.length() > LONGEST || value.contains("\n") ? sha256(value) : value;
    }

    private static String sha256(String text) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return "sha-256 " + HexFormat.of().formatHex(hash);
        } catch (NoSuchAlgorithmException missing) {
            throw new IllegalStateException(missing); // every Java has it
        }
    }
}
