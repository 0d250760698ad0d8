package org.sami.crw.cli.output;

import picocli.CommandLine.IVersionProvider;

/** The version of the build, from the jar's manifest. */
public final class Version implements IVersionProvider {
    /** Version and commit, as the build knew them, such as {@code 0.1.0+3f2a1b4c5d6e}. */
    public static String ofThisProgram() {
        String built = Version.class.getPackage().getImplementationVersion();
        return built == null ? "(not packaged)" : built;
    }

    @Override
    public String[] getVersion() {
        return new String[] {
            "crw " + ofThisProgram(),
            "Java " + System.getProperty("java.version") + ", " + System.getProperty("os.name")
        };
    }
}
